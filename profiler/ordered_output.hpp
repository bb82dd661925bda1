#pragma once
// Text that threads bring out of order and that is written in order.

#include <cstdint>
#include <iosfwd>
#include <map>
#include <mutex>
#include <string>

namespace warpgrain::profiler {

class OrderedOutput {
 public:
  explicit OrderedOutput(std::ostream& out) : out_(out) {}
  // Piece `index`, counted from 0; it is written as soon as all before it are. Every piece comes once.
  void write(std::uint64_t index, std::string text);

 private:
  std::ostream& out_;
  std::mutex mutex_;
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, std::string> waiting_;
};

}  // namespace warpgrain::profiler
