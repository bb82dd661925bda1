#pragma once
// What an instruction computes for one lane: a function from the bits of its inputs to the bits of its
// result. Written from NVIDIA, "Parallel Thread Execution ISA", and from nothing of the simulator's.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <type_traits>
#include <vector>

#include "tests/profiler/oracle/modifiers.hpp"

namespace warpgrain::oracle {

using Bits = std::uint64_t;

struct Operation {
  std::vector<ptx::ScalarType> inputs;
  ptx::ScalarType output;
  std::function<Bits(const Bits* inputs)> compute;
};

// Each knows some opcodes and returns an Operation without `compute` for the others.
Operation integer_operation(const ptx::Statement& statement);
Operation bit_operation(const ptx::Statement& statement);
Operation float_operation(const ptx::Statement& statement);
Operation compare_operation(const ptx::Statement& statement);
Operation convert_operation(const ptx::Statement& statement);
// (old value, operand, second operand of cas) -> new value
Operation atomic_operation(const ptx::Statement& statement, const std::string& name, ptx::ScalarType type);

template <class T>
T value_of(Bits bits) {
  T value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

template <class T>
Bits bits_of(T value) {
  Bits bits = 0;
  std::memcpy(&bits, &value, sizeof value);
  return bits;
}

// What .ftz makes of a value: doubles and integers stay.
template <class T>
T flushed(T x) {
  if constexpr (std::is_same_v<T, float>)
    return std::fpclassify(x) == FP_SUBNORMAL ? std::copysign(0.0f, x) : x;
  else
    return x;
}

// Calls `function` with a value of the C++ integer that has the type's width and signedness.
template <class F>
auto with_integer(const ptx::Statement& statement, ptx::ScalarType type, F&& function) {
  if (type.is_float() || type.is_predicate()) refuse(statement, "an integer type is expected");
  switch (type.bits + (type.is_signed() ? 1 : 0)) {
    case 8:
      return function(std::uint8_t{});
    case 9:
      return function(std::int8_t{});
    case 16:
      return function(std::uint16_t{});
    case 17:
      return function(std::int16_t{});
    case 32:
      return function(std::uint32_t{});
    case 33:
      return function(std::int32_t{});
    case 64:
      return function(std::uint64_t{});
    case 65:
      return function(std::int64_t{});
    default:
      refuse(statement, "the width of its type");
  }
}

template <class F>
auto with_float(const ptx::Statement& statement, ptx::ScalarType type, F&& function) {
  if (!type.is_float() || type.bits == 16) refuse(statement, "f32 or f64 is expected");
  return type.bits == 32 ? function(float{}) : function(double{});
}

// An operation on inputs of one type T, given as a function of one to three values.
template <class T, class F>
Operation uniform_operation(ptx::ScalarType type, F function) {
  Operation operation;
  operation.output = type;
  if constexpr (std::is_invocable_v<F, T, T, T>) {
    operation.inputs = {type, type, type};
    operation.compute = [function](const Bits* in) {
      return bits_of<T>(function(value_of<T>(in[0]), value_of<T>(in[1]), value_of<T>(in[2])));
    };
  } else if constexpr (std::is_invocable_v<F, T, T>) {
    operation.inputs = {type, type};
    operation.compute = [function](const Bits* in) {
      return bits_of<T>(function(value_of<T>(in[0]), value_of<T>(in[1])));
    };
  } else {
    operation.inputs = {type};
    operation.compute = [function](const Bits* in) { return bits_of<T>(function(value_of<T>(in[0]))); };
  }
  return operation;
}

}  // namespace warpgrain::oracle
