#include "profiler/ptx/instruction_facts.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace warpgrain::profiler::ptx {
namespace {

using Class = InstructionClass;

bool has(const Statement& s, std::string_view modifier) {
  return std::find(s.modifiers.begin(), s.modifiers.end(), modifier) != s.modifiers.end();
}

// The last type behind the opcode: of the operation, or of the source where there are two.
ScalarType last_type(const Statement& s) {
  for (auto m = s.modifiers.rbegin(); m != s.modifiers.rend(); ++m)
    if (const auto type = scalar_type(*m)) return *type;
  return bits_type(32);
}

Class class_of_type(ScalarType type) {
  if (type.is_predicate()) return Class::predicate;
  if (!type.is_float()) return Class::integer;
  return type.bits == 64 ? Class::fp64 : type.bits == 16 ? Class::fp16 : Class::fp32;
}

std::optional<StateSpace> space_of(const Statement& s) {
  for (const std::string& m : s.modifiers)
    if (const auto space = state_space(m)) return space;
  return StateSpace::generic;
}

InstructionFacts memory_facts(const Statement& s, bool is_load) {
  const std::uint32_t width = has(s, "v2") ? 2 : has(s, "v4") ? 4 : 1;
  InstructionFacts facts;
  switch (*space_of(s)) {
    case StateSpace::global:
      facts.instruction_class = is_load ? Class::global_load : Class::global_store;
      break;
    case StateSpace::shared:
      facts.instruction_class = is_load ? Class::shared_load : Class::shared_store;
      break;
    case StateSpace::generic:
      facts.instruction_class = is_load ? Class::generic_load : Class::generic_store;
      break;
    case StateSpace::local:
      return {is_load ? Class::local_load : Class::local_store};
    case StateSpace::constant:
      return {Class::constant_load};
    case StateSpace::parameter:
      return {is_load ? Class::parameter_load : Class::move};  // a store prepares a call: a register move
  }
  facts.accessed_bytes = static_cast<std::uint8_t>(width * last_type(s).bytes());
  return facts;
}

// Whether a conversion runs on the special-function unit: between integers and floats, between float widths,
// and rounding a float to an integral value do (F2I, I2F, F2F, FRND in SASS); between integers it is plain
// integer work.
std::uint8_t conversion_operations(const Statement& s) {
  std::optional<ScalarType> to, from;
  for (const std::string& m : s.modifiers)
    if (const auto type = scalar_type(m)) (to ? from : to) = type;
  if (!to || !from) return 0;
  if (to->is_float() != from->is_float()) return 1;
  if (!to->is_float()) return 0;
  if (to->bits != from->bits) return 1;
  return has(s, "rni") || has(s, "rzi") || has(s, "rmi") || has(s, "rpi") ? 1 : 0;
}

InstructionFacts division_facts(const Statement& s) {
  const ScalarType type = last_type(s);
  // A float division is a reciprocal and multiplications; an integer division converts there and back around
  // one.
  InstructionFacts facts{class_of_type(type), static_cast<std::uint8_t>(type.is_float() ? 1 : 3)};
  facts.records_path = type.is_float() && type.bits == 64 && s.opcode == "div" && has(s, "rn");
  return facts;
}

const std::unordered_map<std::string_view, InstructionFacts>& fixed_facts() {
  static const std::unordered_map<std::string_view, InstructionFacts> facts{
      {"sqrt", {Class::special_function, 1}},
      {"rsqrt", {Class::special_function, 1}},
      {"rcp", {Class::special_function, 1}},
      {"sin", {Class::special_function, 1}},
      {"cos", {Class::special_function, 1}},
      {"ex2", {Class::special_function, 1}},
      {"lg2", {Class::special_function, 1}},
      {"tanh", {Class::special_function, 1}},
      {"setp", {Class::predicate}},
      {"mov", {Class::move}},
      {"selp", {Class::move}},
      {"cvta", {Class::move}},
      {"bra", {Class::branch}},
      {"brx", {Class::branch}},
      {"call", {Class::branch}},
      {"ret", {Class::exit}},
      {"exit", {Class::exit}},
      {"bar", {Class::barrier}},
      {"barrier", {Class::barrier}},
      {"shfl", {Class::warp_level}},
      {"vote", {Class::warp_level}},
      {"match", {Class::warp_level}},
      {"activemask", {Class::warp_level}},
      {"elect", {Class::warp_level}},
      {"redux", {Class::warp_level}},
      {"membar", {Class::fence}},
      {"fence", {Class::fence}},
      {"trap", {Class::other}},
      {"prefetch", {Class::other}},
      {"prefetchu", {Class::other}},
  };
  return facts;
}

}  // namespace

InstructionFacts instruction_facts(const Statement& s) {
  if (s.opcode == "ld" || s.opcode == "ldu") return memory_facts(s, true);
  if (s.opcode == "st") return memory_facts(s, false);
  if (s.opcode == "atom" || s.opcode == "red")
    return {Class::atomic, 0, static_cast<std::uint8_t>(last_type(s).bytes())};
  if (s.opcode == "bar" && has(s, "warp")) return {Class::warp_level};
  if (s.opcode == "cvt") return {Class::conversion, conversion_operations(s)};
  if (s.opcode == "div" || s.opcode == "rem") return division_facts(s);
  if (const auto found = fixed_facts().find(s.opcode); found != fixed_facts().end()) return found->second;
  if (has(s, "f16x2")) return {Class::fp16};
  return {class_of_type(last_type(s))};
}

}  // namespace warpgrain::profiler::ptx
