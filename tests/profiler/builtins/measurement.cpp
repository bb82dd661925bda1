#include "tests/profiler/builtins/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "tests/profiler/builtins/samples.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

constexpr std::uint32_t group = 64;

template <class T>
double limit_of(const MathFunction& function) {
  return sizeof(T) == sizeof(float) ? function.limit_float : function.limit_double;
}

template <class T>
std::string program(std::span<const MathFunction> functions) {
  const std::string type = sizeof(T) == sizeof(float) ? "float" : "double";
  std::string text = fmt::format("typedef {0} T;\ntypedef {0}3 T3;\n", type);
  text +=
      "kernel void measured(global T* result, global const T* xs, global const T* ys, global const T* zs,\n"
      "                     global const int* ns, int which) {\n"
      "  const size_t i = get_global_id(0);\n"
      "  const T x = xs[i], y = ys[i], z = zs[i];\n"
      "  const int n = ns[i];\n"
      "  switch (which) {\n";
  for (std::size_t f = 0; f < functions.size(); ++f)
    if (limit_of<T>(functions[f]) != absent)
      text += fmt::format("    case {}: result[i] = {}; break;\n", f, functions[f].call);
  return text + "  }\n}\n";
}

template <class T>
Samples<T> padded(Samples<T> samples) {
  const std::size_t size = (samples.x.size() + group - 1) / group * group;
  samples.x.resize(size);
  samples.y.resize(size);
  samples.z.resize(size);
  samples.n.resize(size);
  return samples;
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
  const auto executable = compile_kernel(program<T>(functions), "measured", TraceMode::none);
  std::vector<Measurement> measured;
  for (std::size_t f = 0; f < functions.size(); ++f) {
    if (limit_of<T>(functions[f]) == absent) continue;
    Samples<T> samples = padded(samples_for<T>(functions[f]));
    std::vector<T> results(samples.x.size());
    const int which = static_cast<int>(f);
    run_launch(*executable, line_of(results.size(), group),
               {buffer_of(results), buffer_of(samples.x), buffer_of(samples.y), buffer_of(samples.z),
                buffer_of(samples.n), scalar_of(which)});
    measured.push_back(compare(functions[f], samples, results));
  }
  return measured;
}

template std::vector<Measurement> measure<float>(std::span<const MathFunction>);
template std::vector<Measurement> measure<double>(std::span<const MathFunction>);

}  // namespace warpgrain::profiler::builtins
