#pragma once
// Which memory an address comes from: followed through moves, sums and selections back to a parameter or a
// variable. So an access beyond the end of one buffer is known even where it hits another one.

#include <string>
#include <unordered_map>
#include <vector>

#include "profiler/access_site.hpp"
#include "profiler/ptx/memory_layout.hpp"
#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

class Provenance {
 public:
  // `kernel` is an entry without calls.
  Provenance(const Module& module, const Function& kernel, const MemoryLayout& layout);

  // Parameters first, in their order; then the variables that the kernel names.
  const std::vector<MemoryObject>& objects() const { return objects_; }
  // Variables of the module among them; MemoryObject::offset counts them.
  const std::vector<const Variable*>& variables() const { return variables_; }
  // The object that an address operand points into, AccessSite::any_object when it may be several.
  std::uint32_t object_of(const Operand& address) const;

 private:
  // An object's index, or one of these.
  static constexpr std::uint32_t number = 0xFFFFFFFE;   // no pointer
  static constexpr std::uint32_t unknown = 0xFFFFFFFF;  // a pointer, or a number, or any of several objects
  using Origin = std::uint32_t;

  static Origin join(Origin a, Origin b);
  void add_objects(const Module& module, const Function& kernel, const MemoryLayout& layout);
  void follow(const Function& kernel);
  Origin origin_of(const Operand& operand) const;
  Origin result_of(const Statement& statement) const;
  Origin loaded(const Statement& statement) const;

  std::vector<MemoryObject> objects_;
  std::vector<const Variable*> variables_;
  std::unordered_map<std::string, Origin> symbols_;     // variables, by name
  std::unordered_map<std::string, Origin> parameters_;  // what a load of the parameter gives
  std::unordered_map<std::string, Origin> held_;        // by registers and by parameters of calls
};

}  // namespace warpgrain::profiler::ptx
