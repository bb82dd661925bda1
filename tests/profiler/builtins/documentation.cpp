#include "tests/profiler/builtins/documentation.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "tests/profiler/builtins/random.hpp"

namespace warpgrain::profiler::builtins {
namespace {

std::string limit_text(const MathFunction& function, double limit) {
  if (limit == absent) return "";
  if (!function.details.limit_text.empty()) return std::string(function.details.limit_text);
  return limit == exact ? "correctly rounded" : fmt::format("{}", limit);
}

const Measurement* find(const std::vector<Measurement>& measured, std::string_view function) {
  const auto found = std::find_if(measured.begin(), measured.end(),
                                  [&](const Measurement& m) { return m.function == function; });
  return found == measured.end() ? nullptr : &*found;
}

std::string worst_text(const Measurement* measured) {
  return measured ? fmt::format("{:.2f}", measured->worst) : "";
}

}  // namespace

std::vector<Section> sections() {
  return {{"Powers, logarithms, angles, special functions", elementary_functions()},
          {"Arithmetic, and functions that take numbers apart", other_math_functions()},
          {"Common and geometric functions", common_functions()},
          {"half_ and native_ functions", approximate_functions()}};
}

SectionMeasurements measure(const Section& section) {
  SectionMeasurements measured{measure<float>(section.functions), {}};
  if (std::any_of(section.functions.begin(), section.functions.end(),
                  [](const MathFunction& f) { return f.limit_double != absent; }))
    measured.in_double = measure<double>(section.functions);
  return measured;
}

std::vector<std::string> rows(const Section& section, const SectionMeasurements& measured) {
  std::vector<std::string> rows;
  for (const MathFunction& f : section.functions) {
    const Measurement* in_float = find(measured.in_float, f.name);
    const Measurement* in_double = find(measured.in_double, f.name);
    rows.push_back(fmt::format("| {} | {} | {} | {} | {} | {} |", f.name, limit_text(f, f.limit_float),
                               worst_text(in_float), limit_text(f, f.limit_double), worst_text(in_double),
                               (in_float ? in_float->samples : 0) + (in_double ? in_double->samples : 0)));
  }
  return rows;
}

std::string page() {
  std::string text = fmt::format(
      "# Accuracy of the built-in functions\n\n"
      "What kernels compute in the simulator, against exact values (MPFR, 200 bits). Written by\n"
      "`build/release/tests/test_profiler_builtins --write-page docs/builtins.md`; the tests measure the "
      "same and fail\n"
      "where a row differs. Samples are edge cases, their combinations, and random values of seed {}.\n\n"
      "Limits and errors are in ULP as OpenCL 1.2 defines them (section 7.4), subnormal results included. "
      "Where OpenCL\n"
      "gives no limit the one used is marked \"ours\" or explained beside the table. Vector forms give the "
      "bits of the\n"
      "scalar ones. All others are compared bit by bit and have no rows here.\n\n"
      "No function misses its limit. `.approx` instructions are modelled: evaluated in double and rounded "
      "once, well\n"
      "within the bounds that NVIDIA's PTX ISA publishes; a device's own last bits differ.\n",
      seed);
  for (const Section& section : sections()) {
    text += fmt::format(
        "\n## {}\n\n| function | limit, float | measured | limit, double | measured | samples |\n"
        "|---|---|---|---|---|---|\n",
        section.title);
    for (const std::string& row : rows(section, measure(section))) text += row + "\n";
  }
  return text +
         "\nOf `native_` functions OpenCL leaves the accuracy to the implementation; limits are those of "
         "the\n"
         "instructions they become, PTX ISA section 9.7.3: `sin`, `cos` 2^-20.5 absolute within 2 pi, `ex2` "
         "2 ULP, `lg2`\n"
         "2^-22 absolute in (0.5, 2) and relative elsewhere, `rcp` 1 ULP, `sqrt` 2^-23 and `rsqrt` 2^-22.9 "
         "relative,\n"
         "`div.approx` 2 ULP. `native_exp` and `native_exp10` round the product with log2(e) or log2(10) "
         "before they take\n"
         "the power: about 1.2 ULP for each unit of the exponent.\n";
}

}  // namespace warpgrain::profiler::builtins
