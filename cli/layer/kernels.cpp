#include "cli/layer/kernels.hpp"

#include <cstring>

namespace warpgrain::layer {
namespace {

const void* handle_in(const void* value) {
  const void* handle = nullptr;
  std::memcpy(&handle, value, sizeof handle);
  return handle;
}

}  // namespace

void Handles::add(const void* handle, Argument::Kind kind) {
  const std::lock_guard lock(mutex_);
  handles_[handle] = {1, kind};
}

void Handles::retain(const void* handle) {
  const std::lock_guard lock(mutex_);
  if (const auto found = handles_.find(handle); found != handles_.end()) ++found->second.references;
}

void Handles::release(const void* handle) {
  const std::lock_guard lock(mutex_);
  const auto found = handles_.find(handle);
  if (found != handles_.end() && --found->second.references == 0) handles_.erase(found);
}

std::optional<Argument::Kind> Handles::kind_of(const void* handle) const {
  const std::lock_guard lock(mutex_);
  const auto found = handles_.find(handle);
  return found == handles_.end() ? std::nullopt : std::optional(found->second.kind);
}

void Kernels::add(cl_kernel kernel, std::shared_ptr<const ProgramText> program, std::string name) {
  const std::lock_guard lock(mutex_);
  kernels_[kernel] = {1, {std::move(program), std::move(name), {}, {}}};
}

void Kernels::clone(cl_kernel kernel, cl_kernel source) {
  const std::lock_guard lock(mutex_);
  if (const auto found = kernels_.find(source); found != kernels_.end()) {
    Kernel copy = found->second.kernel;
    kernels_[kernel] = {1, std::move(copy)};
  }
}

void Kernels::retain(cl_kernel kernel) {
  const std::lock_guard lock(mutex_);
  if (const auto found = kernels_.find(kernel); found != kernels_.end()) ++found->second.references;
}

void Kernels::release(cl_kernel kernel) {
  const std::lock_guard lock(mutex_);
  const auto found = kernels_.find(kernel);
  if (found != kernels_.end() && --found->second.references == 0) kernels_.erase(found);
}

void Kernels::set(cl_kernel kernel, cl_uint index, Argument argument) {
  const std::lock_guard lock(mutex_);
  const auto found = kernels_.find(kernel);
  if (found == kernels_.end()) return;
  std::vector<Argument>& arguments = found->second.kernel.arguments;
  if (arguments.size() <= index) arguments.resize(index + 1);
  arguments[index] = std::move(argument);
}

Parameter Kernels::parameter(cl_kernel kernel, cl_uint index) const {
  const std::lock_guard lock(mutex_);
  const auto found = kernels_.find(kernel);
  if (found == kernels_.end()) return Parameter::unknown;
  const auto known = found->second.kernel.parameters.find(index);
  return known == found->second.kernel.parameters.end() ? Parameter::unknown : known->second;
}

bool Kernels::is_unclear(cl_kernel kernel, cl_uint index, std::size_t size, const void* value) const {
  if (size != sizeof(cl_mem) || parameter(kernel, index) != Parameter::unknown) return false;
  return value == nullptr || !handles_.kind_of(handle_in(value));
}

void Kernels::set_parameter(cl_kernel kernel, cl_uint index, Parameter parameter) {
  const std::lock_guard lock(mutex_);
  if (const auto found = kernels_.find(kernel); found != kernels_.end())
    found->second.kernel.parameters[index] = parameter;
}

void Kernels::set(cl_kernel kernel, cl_uint index, std::size_t size, const void* value) {
  const bool is_pointer = size == sizeof(cl_mem) && parameter(kernel, index) == Parameter::pointer;
  Argument argument;
  argument.size = size;
  if (value == nullptr) {
    argument.kind = is_pointer ? Argument::Kind::null_pointer : Argument::Kind::local;
    return set(kernel, index, std::move(argument));
  }
  argument.kind = Argument::Kind::value;
  if (size == sizeof(cl_mem)) {
    const void* const handle = handle_in(value);
    const auto unknown = !is_pointer         ? Argument::Kind::value
                         : handle == nullptr ? Argument::Kind::null_pointer
                                             : Argument::Kind::unseen;
    argument.kind = handles_.kind_of(handle).value_or(unknown);
    if (argument.kind == Argument::Kind::memory) std::memcpy(&argument.memory, value, size);
  }
  argument.bytes.resize(size);
  std::memcpy(argument.bytes.data(), value, size);
  set(kernel, index, std::move(argument));
}

void Kernels::set_shared_virtual_memory(cl_kernel kernel, cl_uint index) {
  Argument argument;
  argument.kind = Argument::Kind::shared_virtual_memory;
  set(kernel, index, std::move(argument));
}

void Kernels::use_shared_virtual_memory(cl_kernel kernel) {
  const std::lock_guard lock(mutex_);
  if (const auto found = kernels_.find(kernel); found != kernels_.end())
    found->second.kernel.uses_shared_virtual_memory = true;
}

std::optional<Kernel> Kernels::find(cl_kernel kernel) const {
  const std::lock_guard lock(mutex_);
  const auto found = kernels_.find(kernel);
  return found == kernels_.end() ? std::nullopt : std::optional(found->second.kernel);
}

}  // namespace warpgrain::layer
