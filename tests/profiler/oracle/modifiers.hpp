#pragma once
// The modifiers behind an opcode, taken one by one; what is left over or not known is refused by name.

#include <algorithm>
#include <fmt/format.h>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include "profiler/ptx/module.hpp"

namespace warpgrain::oracle {

namespace ptx = profiler::ptx;

// What the interpreter does not know, by name.
class UnknownInstruction : public std::runtime_error {
 public:
  explicit UnknownInstruction(const std::string& what)
      : std::runtime_error("the interpreter does not know " + what) {}
};

[[noreturn]] inline void refuse(const ptx::Statement& statement, const std::string& why) {
  throw UnknownInstruction(fmt::format("'{}': {}", statement.text, why));
}

class Modifiers {
 public:
  explicit Modifiers(const ptx::Statement& statement) : statement_(statement), left_(statement.modifiers) {}

  bool take(const std::string& name) {
    const auto found = std::find(left_.begin(), left_.end(), name);
    if (found == left_.end()) return false;
    left_.erase(found);
    return true;
  }

  // The one of them that is there, else nothing.
  std::string take_one_of(std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (take(name)) return name;
    return {};
  }

  // The first type that is left.
  ptx::ScalarType take_type() {
    for (auto modifier = left_.begin(); modifier != left_.end(); ++modifier)
      if (const auto type = ptx::scalar_type(*modifier)) {
        left_.erase(modifier);
        return *type;
      }
    refuse(statement_, "no type");
  }

  void finish() const {
    if (!left_.empty()) refuse(statement_, "modifier ." + left_.front());
  }

 private:
  const ptx::Statement& statement_;
  std::vector<std::string> left_;
};

}  // namespace warpgrain::oracle
