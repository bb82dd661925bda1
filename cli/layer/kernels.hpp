#pragma once
// The kernels of an application with the arguments that they have been given, and what those name.

#include <CL/cl_icd.h>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/layer/programs.hpp"

namespace warpgrain::layer {

struct Argument {
  enum class Kind {
    unset,
    value,  // `bytes`
    local,  // `size` bytes of local memory
    null_pointer,
    memory,  // buffer, image or pipe
    sampler,
    shared_virtual_memory,
    unseen  // memory that no function of the layer has made
  };
  Kind kind = Kind::unset;
  std::size_t size = 0;
  std::vector<std::byte> bytes;
  cl_mem memory = nullptr;
};

// What the kernel declares, where the argument's size and value do not tell.
enum class Parameter { unknown, value, pointer, local };

struct Kernel {
  std::shared_ptr<const ProgramText> program;
  std::string name;
  std::vector<Argument> arguments;
  std::map<cl_uint, Parameter> parameters;
  bool uses_shared_virtual_memory = false;
};

// Which memory objects and samplers there are, so that the bytes of an argument can be told from a handle.
// Thread safe.
class Handles {
 public:
  void add(cl_mem handle) { add(handle, Argument::Kind::memory); }
  void add(cl_sampler handle) { add(handle, Argument::Kind::sampler); }
  void retain(const void* handle);
  void release(const void* handle);
  // None for what is no living handle.
  std::optional<Argument::Kind> kind_of(const void* handle) const;

 private:
  struct Handle {
    int references = 1;
    Argument::Kind kind;
  };
  void add(const void* handle, Argument::Kind kind);

  mutable std::mutex mutex_;
  std::map<const void*, Handle> handles_;
};

// Thread safe.
class Kernels {
 public:
  explicit Kernels(const Handles& handles) : handles_(handles) {}
  void add(cl_kernel kernel, std::shared_ptr<const ProgramText> program, std::string name);
  void clone(cl_kernel kernel, cl_kernel source);
  void retain(cl_kernel kernel);
  void release(cl_kernel kernel);
  // Whether the parameter has to be known before `set`: a size of 8 without a value may be local memory or a
  // null pointer, and 8 bytes that are no handle may be a number.
  bool is_unclear(cl_kernel kernel, cl_uint index, std::size_t size, const void* value) const;
  void set_parameter(cl_kernel kernel, cl_uint index, Parameter parameter);
  void set(cl_kernel kernel, cl_uint index, std::size_t size, const void* value);
  void set_shared_virtual_memory(cl_kernel kernel, cl_uint index);
  void use_shared_virtual_memory(cl_kernel kernel);
  // With its arguments as they are now; none for a kernel that was never seen.
  std::optional<Kernel> find(cl_kernel kernel) const;

 private:
  struct Counted {
    int references = 1;
    Kernel kernel;
  };
  void set(cl_kernel kernel, cl_uint index, Argument argument);
  Parameter parameter(cl_kernel kernel, cl_uint index) const;

  const Handles& handles_;
  mutable std::mutex mutex_;
  std::map<cl_kernel, Counted> kernels_;
};

}  // namespace warpgrain::layer
