#pragma once
// From the arguments of a launch file to those of a launch, and back to text.

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "profiler/device_buffer.hpp"
#include "profiler/element_type.hpp"
#include "profiler/launch.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/opencl_frontend.hpp"

namespace warpgrain::profiler {

struct BoundArgument {
  KernelArgument argument;
  DeviceBuffer buffer;  // behind `argument` when that is a buffer
  std::string name;
  ElementType type = ElementType::u8;  // of its values
};

// One for each parameter, filled with their data. `declared` may be shorter than `parameters`. A parameter of
// 8 bytes that the PTX does not call a pointer takes a buffer when the file gives it other than 8 bytes or
// any of null, noinit, range, file, ro, wo and dump. Throws InputError with file and line.
std::vector<BoundArgument> bind_arguments(const LaunchFile& file, std::span<const KernelParameter> parameters,
                                          std::span<const ParameterDeclaration> declared);

// Prints the arguments that the file says `dump` of.
void dump_arguments(const LaunchFile& file, std::span<const BoundArgument> bound, std::ostream& out);

}  // namespace warpgrain::profiler
