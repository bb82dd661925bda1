// Integer arithmetic, and the atomic operations, which are arithmetic on what lies in memory.

#include <limits>
#include <type_traits>

#include "tests/profiler/oracle/operation.hpp"

namespace warpgrain::oracle {
namespace {

// Wraps as two's complement does; 64 bits hold every sum and low product of narrower integers.
template <class T>
T wrapped(std::uint64_t value) {
  return static_cast<T>(value);
}

template <class T>
std::uint64_t u(T value) {
  return static_cast<std::uint64_t>(value);
}

// Division by zero gives all ones, its remainder the dividend; the least integer over -1 is itself.
template <class T>
T quotient(T a, T b) {
  if (b == 0) return static_cast<T>(-1);
  if (std::is_signed_v<T> && b == static_cast<T>(-1)) return wrapped<T>(0 - u(a));
  return static_cast<T>(a / b);
}

template <class T>
T remainder_of(T a, T b) {
  if (b == 0) return a;
  if (std::is_signed_v<T> && b == static_cast<T>(-1)) return 0;
  return static_cast<T>(a % b);
}

__extension__ typedef __int128 SignedWide;
__extension__ typedef unsigned __int128 UnsignedWide;
template <class T>
using Wide = std::conditional_t<std::is_signed_v<T>, SignedWide, UnsignedWide>;

// mul and mad: the product's low half, its high half, or all of it.
template <class T>
Operation product(const ptx::Statement& s, const std::string& part, ptx::ScalarType type, bool adds) {
  if (part.empty()) refuse(s, ".lo, .hi or .wide is expected");
  Operation operation;
  operation.output = type;
  if (part == "wide") operation.output.bits = static_cast<std::uint8_t>(type.bits * 2);
  operation.inputs = {type, type};
  if (adds) operation.inputs.push_back(operation.output);
  const unsigned shift = part == "hi" ? type.bits : 0;
  const unsigned kept = operation.output.bits;
  operation.compute = [shift, kept, adds](const Bits* in) {
    const Wide<T> full = static_cast<Wide<T>>(value_of<T>(in[0])) * static_cast<Wide<T>>(value_of<T>(in[1]));
    const Bits result = static_cast<Bits>(full >> shift) + (adds ? in[2] : 0);
    return kept == 64 ? result : result & ((Bits{1} << kept) - 1);
  };
  return operation;
}

template <class T>
Operation arithmetic(const ptx::Statement& s, Modifiers& modifiers, ptx::ScalarType type) {
  const std::string& name = s.opcode;
  if (name == "mul" || name == "mad") {
    const std::string part = modifiers.take_one_of({"lo", "hi", "wide"});
    return product<T>(s, part, type, name == "mad");
  }
  if (name == "add") return uniform_operation<T>(type, [](T a, T b) { return wrapped<T>(u(a) + u(b)); });
  if (name == "sub") return uniform_operation<T>(type, [](T a, T b) { return wrapped<T>(u(a) - u(b)); });
  if (name == "div") return uniform_operation<T>(type, quotient<T>);
  if (name == "rem") return uniform_operation<T>(type, remainder_of<T>);
  if (name == "min") return uniform_operation<T>(type, [](T a, T b) { return b < a ? b : a; });
  if (name == "max") return uniform_operation<T>(type, [](T a, T b) { return a < b ? b : a; });
  if (name == "neg") return uniform_operation<T>(type, [](T a) { return wrapped<T>(0 - u(a)); });
  if (name == "abs") return uniform_operation<T>(type, [](T a) { return a < 0 ? wrapped<T>(0 - u(a)) : a; });
  return {};
}

}  // namespace

Operation integer_operation(const ptx::Statement& statement) {
  static constexpr const char* known[] = {"add", "sub", "mul", "mad", "div",
                                          "rem", "min", "max", "neg", "abs"};
  if (std::find(std::begin(known), std::end(known), statement.opcode) == std::end(known)) return {};
  Modifiers modifiers(statement);
  const ptx::ScalarType type = modifiers.take_type();
  if (type.is_float()) return {};
  const Operation operation = with_integer(
      statement, type, [&](auto sample) { return arithmetic<decltype(sample)>(statement, modifiers, type); });
  modifiers.finish();
  return operation;
}

Operation atomic_operation(const ptx::Statement& statement, const std::string& name, ptx::ScalarType type) {
  if (type.is_float()) {
    if (name != "add") refuse(statement, "an atomic operation on floats");
    return with_float(statement, type, [&](auto sample) {
      using T = decltype(sample);
      return uniform_operation<T>(type, [](T a, T b) { return a + b; });
    });
  }
  return with_integer(statement, type, [&](auto sample) {
    using T = decltype(sample);
    if (name == "add") return uniform_operation<T>(type, [](T a, T b) { return wrapped<T>(u(a) + u(b)); });
    if (name == "min") return uniform_operation<T>(type, [](T a, T b) { return b < a ? b : a; });
    if (name == "max") return uniform_operation<T>(type, [](T a, T b) { return a < b ? b : a; });
    if (name == "and") return uniform_operation<T>(type, [](T a, T b) { return wrapped<T>(u(a) & u(b)); });
    if (name == "or") return uniform_operation<T>(type, [](T a, T b) { return wrapped<T>(u(a) | u(b)); });
    if (name == "xor") return uniform_operation<T>(type, [](T a, T b) { return wrapped<T>(u(a) ^ u(b)); });
    if (name == "exch") return uniform_operation<T>(type, [](T, T b) { return b; });
    if (name == "cas")
      return uniform_operation<T>(type, [](T old, T expected, T b) { return old == expected ? b : old; });
    if (name == "inc")
      return uniform_operation<T>(
          type, [](T old, T limit) { return old >= limit ? T{0} : wrapped<T>(u(old) + 1); });
    if (name == "dec")
      return uniform_operation<T>(
          type, [](T old, T limit) { return old == 0 || old > limit ? limit : wrapped<T>(u(old) - 1); });
    refuse(statement, "the atomic operation");
  });
}

}  // namespace warpgrain::oracle
