#include "variants/cuda_launch.hpp"

#include <cstring>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain {
namespace {

using profiler::KernelArgument;

// What the host needs to hand in a launch and two events, and more.
constexpr double delay_seconds = 50e-6, delay_a_launch = 10e-6;
constexpr std::uint32_t shared_alignment = 256;

std::vector<std::byte> bytes_of(std::uint64_t value) {
  std::vector<std::byte> bytes(sizeof value);
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::uint32_t aligned(std::uint32_t bytes) {
  return (bytes + shared_alignment - 1) / shared_alignment * shared_alignment;
}

}  // namespace

CudaLaunch::CudaLaunch(const CudaDevice& device, const CudaProgram& program,
                       const profiler::KernelSignature& signature, const profiler::LaunchShape& shape,
                       std::span<const KernelArgument> arguments, std::string_view where)
    : device_(&device),
      module_(load_program(device, program, where)),
      function_(module_.function(signature.symbol)),
      shape_(shape),
      delay_(device),
      begin_(device),
      end_(device) {
  if (!shape.is_uniform())
    throw_input_error(where, "a global size that the local size does not divide",
                      "one that it divides: CUDA has no smaller work-groups");
  for (const KernelArgument& argument : arguments) {
    Buffer& buffer = buffers_.emplace_back();
    switch (argument.kind) {
      case KernelArgument::Kind::buffer:
        buffer.first = CudaMemory(device, argument.memory.size());
        buffer.first.write(argument.memory);
        buffer.now = CudaMemory(device, argument.memory.size());
        values_.push_back(bytes_of(buffer.now.address()));
        break;
      case KernelArgument::Kind::scalar:
        values_.push_back(argument.value);
        break;
      case KernelArgument::Kind::local:
        values_.push_back(bytes_of(0));
        break;
    }
  }
  place_shared_memory(signature, arguments);
}

// Memory of the launch's size comes first, then what parameters point to; as in the simulator.
void CudaLaunch::place_shared_memory(const profiler::KernelSignature& signature,
                                     std::span<const KernelArgument> arguments) {
  std::uint32_t end = 0;
  const bool has_dynamic = !signature.parameters.empty() && signature.parameters.back().bytes == 0;
  if (has_dynamic) {
    end = arguments.back().local_bytes;
    values_.pop_back();
  }
  bool has_pointers = false;
  for (std::size_t k = 0; k < values_.size(); ++k)
    has_pointers |= arguments[k].kind == KernelArgument::Kind::local;
  if (has_pointers) {
    const std::uint64_t begin = shared_memory_begin(*device_, function_.static_shared_bytes());
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (arguments[k].kind != KernelArgument::Kind::local) continue;
      const std::uint32_t offset = aligned(end);
      values_[k] = bytes_of(begin + offset);
      values_[k].resize(signature.parameters[k].bytes);
      end = offset + arguments[k].local_bytes;
    }
    end += shared_alignment - 1;
  }
  added_shared_bytes_ = end;
}

void CudaLaunch::restore() {
  for (Buffer& buffer : buffers_) buffer.now.copy_from(buffer.first);
}

void CudaLaunch::launch() {
  std::vector<void*> parameters;
  for (std::vector<std::byte>& value : values_) parameters.push_back(value.data());
  function_.launch(shape_.group_count(), shape_.local_size, added_shared_bytes_, parameters);
}

void CudaLaunch::run_marked() {
  restore();
  device_->synchronize();
  const CudaProfilerRange range;
  launch();
}

double CudaLaunch::run(unsigned times) {
  restore();
  delay_.launch(delay_seconds + times * delay_a_launch);
  begin_.record();
  for (unsigned k = 0; k < times; ++k) launch();
  end_.record();
  const double seconds = end_.seconds_since(begin_);
  device_->synchronize();
  return seconds;
}

}  // namespace warpgrain
