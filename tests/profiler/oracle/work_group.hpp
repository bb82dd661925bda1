#pragma once
// The lanes of one work-group: their registers and memory, and what a step does to one of them.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "profiler/launch.hpp"
#include "tests/profiler/oracle/memory.hpp"
#include "tests/profiler/oracle/program.hpp"

namespace warpgrain::oracle {

class WorkGroup {
 public:
  WorkGroup(const Program& program, Memory& memory, const profiler::LaunchShape& shape,
            const std::array<std::uint64_t, 3>& group);

  std::uint32_t size() const { return static_cast<std::uint32_t>(special_.size()); }

  // Whether the lane takes part in the step.
  bool takes_part(const Step& step, std::uint32_t lane) const;
  // What the step does to the lane's registers and memory.
  void execute(const Step& step, std::uint32_t lane);
  std::uint64_t address(const Step& step, std::uint32_t lane) const {
    return read(step.address, ptx::bits_type(64), lane);
  }
  // Where the lane goes behind the step.
  Place next(const Step& step, std::uint32_t lane) const;

 private:
  Bits read(const Source& source, ptx::ScalarType type, std::uint32_t lane) const;
  void write(const Source& target, Bits value, std::uint32_t lane);
  void compute(const Step& step, std::uint32_t lane);
  void load(const Step& step, std::uint32_t lane);
  void store(const Step& step, std::uint32_t lane);
  void atomic(const Step& step, std::uint32_t lane);

  const Program& program_;
  Memory& memory_;
  std::vector<std::map<std::string, std::uint32_t>> special_;  // [lanes]: registers of that kind
  std::vector<Bits> registers_;                                // [lanes][n_registers]
  std::vector<std::byte> local_;                               // [lanes][local_bytes]
};

}  // namespace warpgrain::oracle
