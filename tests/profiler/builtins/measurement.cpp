#include "tests/profiler/builtins/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "tests/profiler/builtins/samples.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

constexpr std::uint32_t group = 64;
// Vectors of 3 and 16 too fill work-groups.
constexpr std::size_t block = group * 48;

template <class T>
double limit_of(const MathFunction& function) {
  return sizeof(T) == sizeof(float) ? function.limit_float : function.limit_double;
}

// A launch evaluates one function, in vectors of `width`.
template <class T>
std::string program(std::span<const MathFunction> functions, std::uint32_t width) {
  const std::string type = sizeof(T) == sizeof(float) ? "float" : "double";
  const std::string n = width == 1 ? "" : std::to_string(width);
  const auto load = [&](std::string_view array) {
    return width == 1 ? fmt::format("{}[i]", array) : fmt::format("vload{}(i, {})", n, array);
  };
  std::string text = fmt::format(
      "typedef {0}{1} T;\ntypedef {0}3 T3;\ntypedef int{1} I;\n#define AS_T(x) convert_{0}{1}(x)\n"
      "kernel void measured(global {0}* result, global const {0}* xs, global const {0}* ys, global const "
      "{0}* zs,\n"
      "                     global const int* ns, int which) {{\n"
      "  const size_t i = get_global_id(0);\n"
      "  const T x = {2}, y = {3}, z = {4};\n  const I n = {5};\n  T r;\n  switch (which) {{\n",
      type, n, load("xs"), load("ys"), load("zs"), load("ns"));
  for (std::size_t f = 0; f < functions.size(); ++f)
    if (limit_of<T>(functions[f]) != absent)
      text += fmt::format("    case {}: r = {}; break;\n", f, functions[f].call);
  text += "    default: return;\n  }\n";
  return text + (width == 1 ? "  result[i] = r;\n}\n" : fmt::format("  vstore{}(r, i, result);\n}}\n", n));
}

template <class T>
Samples<T> padded(Samples<T> samples) {
  const std::size_t size = (samples.x.size() + block - 1) / block * block;
  samples.x.resize(size);
  samples.y.resize(size);
  samples.z.resize(size);
  samples.n.resize(size);
  return samples;
}

template <class T>
std::vector<T> run(const Executable& executable, std::size_t function, Samples<T>& samples,
                   std::uint32_t width) {
  std::vector<T> results(samples.x.size());
  const int which = static_cast<int>(function);
  run_launch(executable, line_of(results.size() / width, group),
             {buffer_of(results), buffer_of(samples.x), buffer_of(samples.y), buffer_of(samples.z),
              buffer_of(samples.n), scalar_of(which)});
  return results;
}

template <class T>
double error_of(const MathFunction& function, const Arguments& arguments, const Exact& right, T got) {
  const double limit = limit_of<T>(function);
  const MathFunction::Details& details = function.details;
  if (limit != exact)
    return ulp_error(right, got, details.signed_zero,
                     details.absolute ? details.absolute(arguments) / limit : 0);
  const T expected = correctly_rounded<T>(right);
  if (std::isnan(expected) && std::isnan(got)) return 0;
  if (expected == got && (!details.signed_zero || std::signbit(expected) == std::signbit(got))) return 0;
  return std::max(1.0, ulp_error(right, got, details.signed_zero));
}

template <class T>
Measurement compare(const MathFunction& function, const Samples<T>& samples, const std::vector<T>& results) {
  Measurement measured{.function = function.name, .limit = limit_of<T>(function)};
  Exact right;
  for (std::size_t i = 0; i < samples.x.size(); ++i) {
    const Arguments arguments{samples.x[i], samples.y[i], samples.z[i], samples.n[i],
                              std::numeric_limits<T>::digits};
    if (function.details.defined && !function.details.defined(arguments)) continue;
    ++measured.samples;
    function.reference(right.get(), arguments);
    const double error = error_of(function, arguments, right, results[i]);
    if (error <= measured.worst) continue;
    measured.worst = error;
    measured.worst_case = fmt::format(
        "x = {:a} ({}), y = {:a} ({}), z = {:a}, n = {}: {:a} ({}), not {:a}", arguments.x, arguments.x,
        arguments.y, arguments.y, arguments.z, arguments.n, static_cast<double>(results[i]),
        static_cast<double>(results[i]), static_cast<double>(correctly_rounded<T>(right)));
  }
  return measured;
}

}  // namespace

template <class T>
std::vector<Measurement> measure(std::span<const MathFunction> functions) {
  const auto executable = compile_kernel(program<T>(functions, 1), "measured", TraceMode::none);
  std::vector<Measurement> measured;
  for (std::size_t f = 0; f < functions.size(); ++f) {
    if (limit_of<T>(functions[f]) == absent) continue;
    const Samples<T> chosen = samples_for<T>(functions[f]);
    Samples<T> samples = padded(chosen);
    measured.push_back(compare(functions[f], chosen, run(*executable, f, samples, 1)));
  }
  return measured;
}

template <class T>
std::vector<std::string> differences_in_vectors(std::span<const MathFunction> functions,
                                                std::uint32_t width) {
  std::vector<MathFunction> of_components;
  for (const MathFunction& f : functions)
    if (f.call.find("T3") == std::string_view::npos) of_components.push_back(f);
  const auto scalars = compile_kernel(program<T>(of_components, 1), "measured", TraceMode::none);
  const auto vectors = compile_kernel(program<T>(of_components, width), "measured", TraceMode::none);
  std::vector<std::string> differences;
  for (std::size_t f = 0; f < of_components.size(); ++f) {
    if (limit_of<T>(of_components[f]) == absent) continue;
    Samples<T> samples = padded(samples_for<T>(of_components[f]));
    const std::vector<T> expected = run(*scalars, f, samples, 1), got = run(*vectors, f, samples, width);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i] == got[i] || (std::isnan(expected[i]) && std::isnan(got[i]))) continue;
      differences.push_back(fmt::format("{}, x = {}, y = {}: {}, not {}", of_components[f].name, samples.x[i],
                                        samples.y[i], got[i], expected[i]));
      break;
    }
  }
  return differences;
}

template std::vector<Measurement> measure<float>(std::span<const MathFunction>);
template std::vector<Measurement> measure<double>(std::span<const MathFunction>);
template std::vector<std::string> differences_in_vectors<float>(std::span<const MathFunction>, std::uint32_t);
template std::vector<std::string> differences_in_vectors<double>(std::span<const MathFunction>,
                                                                 std::uint32_t);

}  // namespace warpgrain::profiler::builtins
