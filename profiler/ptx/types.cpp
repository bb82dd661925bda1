#include "profiler/ptx/types.hpp"

#include <string>
#include <unordered_map>

namespace warpgrain::profiler::ptx {

std::optional<ScalarType> scalar_type(std::string_view name) {
  using Kind = ScalarType::Kind;
  static const std::unordered_map<std::string_view, ScalarType> types{
      {"b8", {Kind::bits, 8}},
      {"b16", {Kind::bits, 16}},
      {"b32", {Kind::bits, 32}},
      {"b64", {Kind::bits, 64}},
      {"u8", {Kind::unsigned_integer, 8}},
      {"u16", {Kind::unsigned_integer, 16}},
      {"u32", {Kind::unsigned_integer, 32}},
      {"u64", {Kind::unsigned_integer, 64}},
      {"s8", {Kind::signed_integer, 8}},
      {"s16", {Kind::signed_integer, 16}},
      {"s32", {Kind::signed_integer, 32}},
      {"s64", {Kind::signed_integer, 64}},
      {"f16", {Kind::floating, 16}},
      {"f32", {Kind::floating, 32}},
      {"f64", {Kind::floating, 64}},
      {"pred", predicate_type},
  };
  const auto found = types.find(name);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

std::optional<StateSpace> state_space(std::string_view name) {
  static const std::unordered_map<std::string_view, StateSpace> spaces{
      {"global", StateSpace::global},
      {"shared", StateSpace::shared},
      {"shared::cta", StateSpace::shared},
      {"const", StateSpace::constant},
      {"local", StateSpace::local},
      {"param", StateSpace::parameter},
      {"param::entry", StateSpace::parameter},
      {"param::func", StateSpace::parameter},
  };
  const auto found = spaces.find(name);
  if (found == spaces.end()) return std::nullopt;
  return found->second;
}

}  // namespace warpgrain::profiler::ptx
