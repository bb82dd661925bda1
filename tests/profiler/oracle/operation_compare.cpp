// Comparisons and selections.

#include <cmath>

#include "tests/profiler/oracle/operation.hpp"

namespace warpgrain::oracle {
namespace {

using Compare = std::function<bool(Bits, Bits)>;

template <class T>
Compare ordered(const std::string& name) {
  const auto of = [](auto relation) {
    return [relation](Bits a, Bits b) { return relation(value_of<T>(a), value_of<T>(b)); };
  };
  if (name == "eq") return of([](T a, T b) { return a == b; });
  if (name == "lt" || name == "lo") return of([](T a, T b) { return a < b; });
  if (name == "le" || name == "ls") return of([](T a, T b) { return a <= b; });
  if (name == "gt" || name == "hi") return of([](T a, T b) { return a > b; });
  if (name == "ge" || name == "hs") return of([](T a, T b) { return a >= b; });
  if (name == "ne") return of([](T a, T b) { return a < b || a > b; });  // of NaN false
  return {};
}

// Of floats: `equ`, `neu`, ... hold of NaN, too.
template <class T>
Compare of_floats(const std::string& name) {
  const auto any_nan = [](Bits a, Bits b) {
    return std::isnan(value_of<T>(a)) || std::isnan(value_of<T>(b));
  };
  if (name == "num") return [any_nan](Bits a, Bits b) { return !any_nan(a, b); };
  if (name == "nan") return any_nan;
  if (name.size() == 3 && name.back() == 'u')
    return [any_nan, relation = ordered<T>(name.substr(0, 2))](Bits a, Bits b) {
      return any_nan(a, b) || relation(a, b);
    };
  return ordered<T>(name);
}

Operation setp(const ptx::Statement& s, Modifiers& modifiers) {
  const std::string name = modifiers.take_one_of({"eq", "ne", "lt", "le", "gt", "ge", "equ", "neu", "ltu",
                                                  "leu", "gtu", "geu", "num", "nan", "lo", "ls", "hi", "hs"});
  const std::string combination = modifiers.take_one_of({"and", "or", "xor"});
  const bool flushes = modifiers.take("ftz");
  const ptx::ScalarType type = modifiers.take_type();
  Compare relation =
      type.is_float() ? with_float(s, type, [&](auto sample) { return of_floats<decltype(sample)>(name); })
                      : with_integer(s, type, [&](auto sample) { return ordered<decltype(sample)>(name); });
  if (!relation) refuse(s, "the comparison");
  if (flushes && type.bits == 32)
    relation = [exact = relation](Bits a, Bits b) {
      return exact(bits_of(flushed(value_of<float>(a))), bits_of(flushed(value_of<float>(b))));
    };
  Operation operation{{type, type}, ptx::predicate_type, {}};
  if (combination.empty()) {
    operation.compute = [relation](const Bits* in) { return Bits{relation(in[0], in[1])}; };
    return operation;
  }
  operation.inputs.push_back(ptx::predicate_type);
  operation.compute = [relation, combination](const Bits* in) -> Bits {
    const Bits result = relation(in[0], in[1]) ? 1 : 0;
    return combination == "and" ? result & in[2] : combination == "or" ? result | in[2] : result ^ in[2];
  };
  return operation;
}

}  // namespace

Operation compare_operation(const ptx::Statement& statement) {
  if (statement.opcode != "setp" && statement.opcode != "selp") return {};
  Modifiers modifiers(statement);
  Operation operation;
  if (statement.opcode == "setp") {
    operation = setp(statement, modifiers);
  } else {
    const ptx::ScalarType type = modifiers.take_type();
    operation = {
        {type, type, ptx::predicate_type}, type, [](const Bits* in) { return in[2] != 0 ? in[0] : in[1]; }};
  }
  modifiers.finish();
  return operation;
}

}  // namespace warpgrain::oracle
