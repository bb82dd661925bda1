#pragma once
// What a kernel may touch and where it does: the static half of the memory checks. Plain data; the translator
// makes it, the checks of a launch read it.

#include <cstdint>
#include <string>
#include <vector>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler {

// Memory that an address can be followed back to.
struct MemoryObject {
  enum class Kind : std::uint8_t {
    parameter,  // what the pointer in parameter `offset` points to; nothing where the launch gives a scalar
    shared,     // a variable, `offset` bytes into the static shared memory
    local,      // a variable, `offset` bytes into the lane's local memory
    variable    // of the module, variable `offset` of those that the native code lists
  };
  Kind kind = Kind::parameter;
  std::string name;
  std::uint32_t offset = 0;
  std::uint64_t bytes = 0;  // 0 for parameters: the launch says
  bool read_only = false;
};

enum class AccessKind : std::uint8_t { load, store, atomic };
enum class AccessSpace : std::uint8_t { generic, global, shared, constant, local, parameter };

// An instruction that touches memory. The address of most can be followed back to one object.
struct AccessSite {
  static constexpr std::uint32_t any_object = 0xFFFFFFFF;

  std::uint32_t line = 0;  // of the PTX
  AccessKind kind = AccessKind::load;
  AccessSpace space = AccessSpace::generic;
  std::uint8_t element_bytes = 1;
  std::uint8_t bytes = 1;             // vector width included; what the address must be a multiple of
  bool ordered = false;               // atomic, or .relaxed and the like: no race with others of its sort
  std::uint32_t object = any_object;  // index into the kernel's objects
};

// A loop that a lane may be stopped in.
struct LoopFacts {
  std::uint32_t line = 0;         // of the PTX, where its first block begins
  bool waits_for_memory = false;  // it reads memory that others see and stores nothing
};

struct MemoryFacts {
  std::vector<MemoryObject> objects;
  std::vector<AccessSite> sites;
  bool has_fence = false;
};

}  // namespace warpgrain::profiler
