#include "cli/measure_launch.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "profiler/loaded_launch.hpp"
#include "reports/source_text.hpp"
#include "variants/cuda_launch.hpp"

namespace warpgrain::cli {
namespace {

using profiler::BoundArgument;
using profiler::KernelArgument;
using profiler::LoadedLaunch;

void keep_program(const CudaProgram& program, const std::filesystem::path& folder, const std::string& name) {
  make_folder(folder);
  write_file_atomically(folder / (name + ".ptx"), program.ptx);
  if (!program.cubin.empty()) write_file_atomically(folder / (name + ".cubin"), program.cubin);
}

template <class Float>
double largest_difference(std::span<const std::byte> device, std::span<const std::byte> simulated) {
  double largest = 0, difference = 0;
  for (std::size_t at = 0; at + sizeof(Float) <= device.size(); at += sizeof(Float)) {
    Float a = 0, b = 0;
    std::memcpy(&a, device.data() + at, sizeof a);
    std::memcpy(&b, simulated.data() + at, sizeof b);
    if (std::memcmp(&a, &b, sizeof a) == 0) continue;
    if (std::isfinite(b)) largest = std::max(largest, std::abs(static_cast<double>(b)));
    const double between = std::abs(static_cast<double>(a) - static_cast<double>(b));
    difference = std::isfinite(between) ? std::max(difference, between) : HUGE_VAL;
  }
  if (difference == 0) return 0;
  // A NaN on one side alone is as far off as can be.
  return std::isfinite(difference) && largest > 0 ? difference / largest : 1;
}

reports::MeasuredReport::Agreement compare(const BoundArgument& device,
                                           std::span<const std::byte> simulated) {
  const std::span<const std::byte> bytes = device.buffer.bytes();
  const std::size_t size = profiler::element_size(device.type);
  reports::MeasuredReport::Agreement agreement{device.name, bytes.size() / size, 0, 0};
  for (std::size_t at = 0; at + size <= bytes.size(); at += size)
    agreement.differing += std::memcmp(bytes.data() + at, simulated.data() + at, size) != 0;
  if (agreement.differing == 0) return agreement;
  agreement.largest_difference =
      device.type == profiler::ElementType::f32   ? largest_difference<float>(bytes, simulated)
      : device.type == profiler::ElementType::f64 ? largest_difference<double>(bytes, simulated)
                                                  : 1;
  return agreement;
}

}  // namespace

reports::MeasuredReport measure_launch(const LaunchMeasurement& what,
                                       const reports::MeasuredReport* earlier) {
  const CudaAssembler assembler = cuda_assembler(what.assembler, "--assembler");
  const profiler::LaunchFile file = profiler::read_launch_file(what.launch);
  const CudaDevice device(what.device);
  LoadedLaunch loaded = profiler::load_launch(file, what.build_options);
  const CudaProgram program = assemble_for_cuda(device, assembler, loaded.program.ptx, what.launch);
  if (!what.keep.empty()) keep_program(program, what.keep, file.path.stem().string());

  std::vector<KernelArgument> arguments;
  for (const BoundArgument& bound : loaded.arguments) arguments.push_back(bound.argument);
  CudaLaunch launch(device, program, loaded.signature, loaded.shape, arguments, what.launch);
  reports::MeasuredReport::Kernel kernel;
  kernel.kernel = file.kernel;
  kernel.launch_file = what.launch;
  kernel.global_size = loaded.shape.global_size;
  const auto& [x, y, z] = loaded.shape.local_size;
  kernel.local_size = {x, y, z};
  kernel.calls = what.in_a_row;
  if (earlier != nullptr && !earlier->kernels.empty()) kernel.seconds = earlier->kernels[0].seconds;
  for (unsigned k = 0; k < what.warm_up; ++k) launch.run();
  while (kernel.seconds.size() < what.repeats && !interrupted())
    kernel.seconds.push_back(launch.run(what.in_a_row));
  if (kernel.seconds.empty()) throw Interrupted();
  if (what.mark) launch.run_marked();
  if (what.in_a_row != 1 || earlier != nullptr) launch.run();  // what is read below is of one launch
  kernel.code = {program.assembler, reports::text_hash(loaded.program.ptx),
                 static_cast<std::uint64_t>(launch.function().registers()),
                 static_cast<std::uint64_t>(launch.shared_bytes()),
                 static_cast<std::uint64_t>(launch.function().local_bytes())};

  for (std::size_t k = 0; k < loaded.arguments.size(); ++k)
    launch.read(k, loaded.arguments[k].buffer.bytes());
  if (!interrupted()) dump_arguments(file, loaded.arguments, std::cout);
  if (what.check && !interrupted()) {
    std::ostringstream dumps;  // the simulator's, which nobody asked for
    profiler::ProfileOptions options;
    options.addresses = false;
    options.checks = profiler::Checks::off;
    const auto simulated = profile_launch_file(file, what.build_options, options, dumps);
    for (std::size_t k = 0; k < loaded.arguments.size(); ++k)
      if (!loaded.arguments[k].buffer.bytes().empty())
        kernel.agreement.push_back(compare(loaded.arguments[k], simulated.buffers[k].bytes()));
  }

  reports::MeasuredReport report;
  report.generator = reports::this_generator();
  report.command_line = command_line();
  report.backend = "cuda";
  report.device = {device.name(), device.architecture(), device.driver()};
  report.kernels.push_back(std::move(kernel));
  return report;
}

}  // namespace warpgrain::cli
