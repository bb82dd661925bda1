// Arithmetic of floats, each operation rounded once to nearest. Approximate instructions are evaluated as
// exactly as their type allows, which is what the simulator says it does.

#include <bit>
#include <cmath>
#include <type_traits>

#include "tests/profiler/oracle/operation.hpp"

namespace warpgrain::oracle {
namespace {

// .sat: to [0, 1], NaN to 0.
template <class T>
T saturated(T x) {
  return x > 1 ? T{1} : x > 0 ? x : T{0};
}

// NaN gives way to a number; -0 is less than +0.
template <class T>
T least(T a, T b) {
  if (std::isnan(a)) return b;
  if (std::isnan(b)) return a;
  if (a == b) return std::signbit(a) ? a : b;
  return a < b ? a : b;
}

template <class T>
T function_of(const std::string& name, T x) {
  if (name == "neg") return -x;
  if (name == "abs") return std::fabs(x);
  if (name == "sqrt") return std::sqrt(x);
  if (name == "rcp") return T{1} / x;
  if (name == "rsqrt") return static_cast<T>(1.0 / std::sqrt(static_cast<double>(x)));
  if (name == "sin") return std::sin(x);
  if (name == "cos") return std::cos(x);
  if (name == "ex2") return std::exp2(x);
  return std::log2(x);
}

template <class T>
Operation arithmetic(const std::string& name, ptx::ScalarType type, bool flushes, bool saturates) {
  const auto in = [flushes](T x) { return flushes ? flushed(x) : x; };
  const auto out = [flushes, saturates](T x) {
    const T y = flushes ? flushed(x) : x;
    return saturates ? saturated(y) : y;
  };
  const auto binary = [&](auto function) {
    return uniform_operation<T>(type, [=](T a, T b) { return out(function(in(a), in(b))); });
  };
  if (name == "add") return binary([](T a, T b) { return a + b; });
  if (name == "sub") return binary([](T a, T b) { return a - b; });
  if (name == "mul") return binary([](T a, T b) { return a * b; });
  if (name == "div") return binary([](T a, T b) { return a / b; });
  if (name == "min") return binary(least<T>);
  if (name == "max") return binary([](T a, T b) { return -least<T>(-a, -b); });
  if (name == "copysign") return binary([](T a, T b) { return std::copysign(b, a); });
  if (name == "fma" || name == "mad")
    return uniform_operation<T>(type, [=](T a, T b, T c) { return out(std::fma(in(a), in(b), in(c))); });
  return uniform_operation<T>(type, [=](T x) { return out(function_of<T>(name, in(x))); });
}

}  // namespace

Operation float_operation(const ptx::Statement& statement) {
  static constexpr const char* known[] = {"add",      "sub",   "mul", "div", "min", "max",
                                          "copysign", "fma",   "mad", "neg", "abs", "sqrt",
                                          "rcp",      "rsqrt", "sin", "cos", "ex2", "lg2"};
  if (std::find(std::begin(known), std::end(known), statement.opcode) == std::end(known)) return {};
  Modifiers modifiers(statement);
  const ptx::ScalarType type = modifiers.take_type();
  if (!type.is_float()) return {};
  modifiers.take_one_of({"approx", "full"});
  modifiers.take("rn");
  const bool flushes = modifiers.take("ftz"), saturates = modifiers.take("sat");
  modifiers.finish();
  return with_float(statement, type, [&](auto sample) {
    return arithmetic<decltype(sample)>(statement.opcode, type, flushes, saturates);
  });
}

}  // namespace warpgrain::oracle
