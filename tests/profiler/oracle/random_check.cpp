#include "tests/profiler/oracle/random_check.hpp"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <random>

#include "profiler/device_buffer.hpp"
#include "profiler/opencl_frontend.hpp"
#include "tests/profiler/oracle/comparison.hpp"

namespace warpgrain::oracle {
namespace {

using profiler::DeviceBuffer;
using profiler::KernelArgument;

// A launch's buffers, filled.
class Data {
 public:
  explicit Data(const RandomKernel& kernel)
      : in_(words(RandomKernel::in_words)),
        out_(words(RandomKernel::out_words_a_lane * kernel.shape.global_size[0] *
                   kernel.shape.global_size[1] * kernel.shape.global_size[2])),
        sums_(words(RandomKernel::sum_words)) {
    std::mt19937 random(static_cast<std::mt19937::result_type>(kernel.seed));
    for (std::size_t i = 0; i < RandomKernel::in_words; ++i)
      reinterpret_cast<std::uint32_t*>(in_.bytes().data())[i] =
          static_cast<std::uint32_t>(random()) >> (random() % 32);
  }

  std::vector<KernelArgument> arguments() {
    return {KernelArgument::buffer(in_.bytes()), KernelArgument::buffer(out_.bytes()),
            KernelArgument::buffer(sums_.bytes()),
            KernelArgument::scalar(std::as_bytes(std::span(&RandomKernel::n, 1)))};
  }

 private:
  static DeviceBuffer words(std::uint64_t n) { return DeviceBuffer(n * sizeof(std::uint32_t)); }
  DeviceBuffer in_, out_, sums_;
};

// The program without the entries of other kernels and without debug sections: reading all of them again for
// each kernel takes longer than running one.
std::string without_others(const std::string& ptx, const std::string& kernel) {
  const std::string begin = ".visible .entry ", end = "\n}\n";
  const std::size_t finish = std::min(ptx.find("\t.section"), ptx.size());
  std::string text;
  for (std::size_t at = 0; at < finish;) {
    const std::size_t entry = std::min(ptx.find(begin, at), finish);
    text += ptx.substr(at, entry - at);
    if (entry == finish) break;
    at = ptx.find(end, entry) + end.size();
    if (ptx.compare(entry + begin.size(), kernel.size() + 1, kernel + "(") == 0)
      text += ptx.substr(entry, at - entry);
  }
  return text;
}

std::vector<std::string> check(const RandomKernel& kernel, const std::string& source, const std::string& ptx,
                               const ReferenceRun& reference) {
  Data here(kernel), there(kernel);
  const std::vector<KernelArgument> arguments = here.arguments(), expected = there.arguments();
  std::vector<std::string> lines = differences(ptx, kernel.name, kernel.shape, arguments);
  reference(source, kernel.name, kernel.shape, expected);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (!std::ranges::equal(arguments[i].memory, expected[i].memory)) {
      const auto [a, b] = std::ranges::mismatch(arguments[i].memory, expected[i].memory);
      lines.push_back(fmt::format("argument {}, byte {}: simulated {:#x}, reference {:#x}", i,
                                  a - arguments[i].memory.begin(), static_cast<int>(*a),
                                  static_cast<int>(*b)));
    }
  return lines;
}

}  // namespace

std::vector<Finding> check_kernels(std::span<const RandomKernel> kernels, const ReferenceRun& reference) {
  std::string source;
  for (const RandomKernel& kernel : kernels) source += kernel.source;
  const std::string ptx = profiler::compile_opencl(source, "random.cl").ptx;
  std::vector<Finding> findings;
  for (const RandomKernel& kernel : kernels) {
    Finding finding{&kernel, {}};
    try {
      finding.lines = check(kernel, source, without_others(ptx, kernel.name), reference);
    } catch (const std::exception& error) {
      finding.lines = {fmt::format("stopped: {}", error.what())};
    }
    if (!finding.lines.empty()) findings.push_back(std::move(finding));
  }
  return findings;
}

std::vector<Finding> check_ptx_kernels(std::span<const RandomKernel> kernels) {
  std::vector<Finding> findings;
  for (const RandomKernel& kernel : kernels) {
    Finding finding{&kernel, {}};
    try {
      Data data(kernel);
      finding.lines = differences(kernel.source, kernel.name, kernel.shape, data.arguments());
    } catch (const std::exception& error) {
      finding.lines = {fmt::format("stopped: {}", error.what())};
    }
    if (!finding.lines.empty()) findings.push_back(std::move(finding));
  }
  return findings;
}

std::string report(const Finding& finding) {
  return fmt::format("seed {}:\n{}\n{}", finding.kernel->seed, fmt::join(finding.lines, "\n"),
                     finding.kernel->source);
}

}  // namespace warpgrain::oracle
