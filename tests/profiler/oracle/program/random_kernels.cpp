// Checks random kernels by the thousand: simulator, interpreter and PoCL must agree on each.
//
//   random_kernels --kernels 20000 --seed 1         seeds 1 to 20000; exits 1 when any differ
//   random_kernels --kernels 20000 --ptx            kernels in PTX, which need no compiler
//   random_kernels --seed 4711 --print              the source of one, without running it
//   random_kernels --seed 4711 --source reduced.cl  its text from a file: for reducers, which look at
//                                                   the exit status

#include <CLI/CLI.hpp>
#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/profiler/oracle/random_check.hpp"
#include "tests/profiler/pocl.hpp"

namespace {

using namespace warpgrain;

struct Options {
  std::uint64_t kernels = 1, seed = 1, batch = 50;
  double seconds = 1e9;
  bool print = false, ptx = false;
  std::string source;
};

oracle::RandomKernel kernel_of(const Options& options, std::uint64_t seed) {
  oracle::RandomKernel kernel = options.ptx ? oracle::random_ptx_kernel(seed) : oracle::random_kernel(seed);
  if (options.source.empty()) return kernel;
  std::ifstream in(options.source);
  std::ostringstream text;
  if (!(text << in.rdbuf())) throw std::runtime_error("cannot read " + options.source);
  kernel.source = text.str();
  return kernel;
}

// The number of kernels that differ.
std::uint64_t run(const Options& options) {
  profiler::Pocl pocl(oracle::reference_options);
  const auto reference = [&](const auto&... launch) { pocl.run(launch...); };
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  std::uint64_t found = 0, done = 0;
  while (done < options.kernels && seconds() < options.seconds) {
    std::vector<oracle::RandomKernel> kernels;
    while (kernels.size() < options.batch && done < options.kernels)
      kernels.push_back(kernel_of(options, options.seed + done++));
    // So that a crash, of PoCL's compiler, say, can be looked for.
    std::cerr << fmt::format("seeds {} to {}\n", kernels.front().seed, kernels.back().seed);
    const auto findings =
        options.ptx ? oracle::check_ptx_kernels(kernels) : oracle::check_kernels(kernels, reference);
    for (const oracle::Finding& finding : findings) {
      ++found;
      std::cout << oracle::report(finding) << std::endl;
    }
  }
  std::cout << fmt::format("{} kernels from seed {} on in {:.1f} s: {} differ\n", done, options.seed,
                           seconds(), found);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Checks random kernels: simulator, interpreter and PoCL must agree.");
  app.add_option("--kernels", options.kernels, "how many")->capture_default_str();
  app.add_option("--seed", options.seed, "of the first; the others follow")->capture_default_str();
  app.add_option("--batch", options.batch, "kernels a compiler call")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", options.seconds, "begins no batch after that time");
  app.add_flag("--print", options.print, "prints sources and runs nothing");
  app.add_flag("--ptx", options.ptx, "kernels in PTX: simulator and interpreter alone");
  app.add_option("--source", options.source, "a file in place of the generated text")
      ->check(CLI::ExistingFile);
  CLI11_PARSE(app, argc, argv);
  setenv("POCL_KERNEL_CACHE", "0", 1);  // nobody needs these kernels again
  try {
    if (!options.print) return run(options) == 0 ? 0 : 1;
    for (std::uint64_t i = 0; i < options.kernels; ++i)
      std::cout << kernel_of(options, options.seed + i).source;
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "random_kernels: " << error.what() << '\n';
    return 2;
  }
}
