#include "profiler/launch_check.hpp"

#include <fmt/format.h>
#include <limits>

#include "core/error.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::uint64_t max_work_group = 1024;  // of every NVIDIA device since Fermi
// The largest alignment of an OpenCL type, which a __local pointer may need (long16).
constexpr std::size_t local_alignment = 128;
constexpr std::uint32_t pointer_bytes = 8;

const char* kind_name(KernelArgument::Kind kind) {
  return kind == KernelArgument::Kind::buffer  ? "a buffer"
         : kind == KernelArgument::Kind::local ? "local memory"
                                               : "a scalar";
}

}  // namespace

void check_shape(const TranslatedKernel& kernel, const LaunchShape& shape) {
  std::uint64_t work_group = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::uint64_t global = shape.global_size[d];
    const std::uint64_t local = shape.local_size[d];
    if (local == 0 || global == 0)
      throw_input_error(kernel.place(),
                        fmt::format("global size {} and local size {} in dimension {}", global, local, d),
                        "sizes above 0");
    if (global % local != 0 && !kernel.takes_smaller_groups)
      throw_input_error(
          kernel.place(), fmt::format("global size {} and local size {} in dimension {}", global, local, d),
          "a global size that the local size divides: only OpenCL C has smaller last work-groups");
    if (global / local >= std::numeric_limits<std::uint32_t>::max())
      throw_input_error(kernel.place(), fmt::format("{} work-groups in dimension {}", global / local, d),
                        "fewer than 2^32");
    work_group *= local;
    if (work_group > max_work_group)
      throw_input_error(kernel.place(),
                        fmt::format("a local size of {} x {} x {}", shape.local_size[0], shape.local_size[1],
                                    shape.local_size[2]),
                        fmt::format("at most {} work-items in a work-group", max_work_group));
  }
  if (kernel.required_local_size && *kernel.required_local_size != shape.local_size) {
    const auto& r = *kernel.required_local_size;
    throw_input_error(kernel.place(),
                      fmt::format("a local size of {} x {} x {}", shape.local_size[0], shape.local_size[1],
                                  shape.local_size[2]),
                      fmt::format("{} x {} x {}, which the kernel requires", r[0], r[1], r[2]));
  }
}

void check_arguments(const TranslatedKernel& kernel, std::span<const KernelArgument> arguments) {
  if (arguments.size() != kernel.parameters.size())
    throw_input_error(kernel.place(), fmt::format("{} arguments", arguments.size()),
                      fmt::format("{}", kernel.parameters.size()));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const KernelArgument& argument = arguments[i];
    const KernelParameter& parameter = kernel.parameters[i];
    const auto refuse = [&](const std::string& what, const std::string& expected) {
      throw_input_error(fmt::format("{}, argument {} ({})", kernel.place(), i, parameter.name), what,
                        expected);
    };
    const bool is_pointer = argument.kind != KernelArgument::Kind::scalar;
    switch (parameter.pointer) {
      case KernelParameter::Pointer::global:
      case KernelParameter::Pointer::constant:
        if (argument.kind != KernelArgument::Kind::buffer) refuse(kind_name(argument.kind), "a buffer");
        break;
      case KernelParameter::Pointer::shared:
        if (argument.kind != KernelArgument::Kind::local) refuse(kind_name(argument.kind), "local memory");
        break;
      case KernelParameter::Pointer::none:
        // CUDA's PTX does not say which parameters are pointers.
        if (is_pointer && parameter.bytes != pointer_bytes)
          refuse(kind_name(argument.kind), fmt::format("a scalar of {} bytes", parameter.bytes));
        if (!is_pointer && argument.value.size() != parameter.bytes)
          refuse(fmt::format("a scalar of {} bytes", argument.value.size()),
                 fmt::format("{} bytes", parameter.bytes));
        break;
    }
  }
}

std::uint32_t dynamic_shared_offset(std::uint32_t static_bytes) {
  return static_cast<std::uint32_t>((static_bytes + local_alignment - 1) / local_alignment * local_alignment);
}

std::vector<std::size_t> shared_offsets(const TranslatedKernel& kernel,
                                        std::span<const KernelArgument> arguments) {
  std::vector<std::size_t> offsets(arguments.size() + 1);
  std::size_t end = kernel.graph.shared_bytes;
  const auto place = [&](std::size_t i) {
    if (arguments[i].kind == KernelArgument::Kind::local)
      end = (end + local_alignment - 1) / local_alignment * local_alignment;
    offsets[i] = end;
    if (arguments[i].kind == KernelArgument::Kind::local) end += arguments[i].local_bytes;
  };
  // Memory of the launch's size comes first: translated code knows its place.
  const bool has_dynamic = kernel.has_dynamic_shared();
  if (has_dynamic) place(arguments.size() - 1);
  for (std::size_t i = 0; i + (has_dynamic ? 1 : 0) < arguments.size(); ++i) place(i);
  offsets.back() = end;
  return offsets;
}

}  // namespace warpgrain::profiler
