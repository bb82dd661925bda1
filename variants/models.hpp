#pragma once
// How much of the model is compiled in: one row here.

#include <array>
#include <span>
#include <string_view>

#include "variants/axes.hpp"

namespace warpgrain {

struct ModelExtent {
  std::string_view name;  // value of the axis `model`
  std::string_view summary;
  bool is_full;
};

inline std::span<const ModelExtent> model_extents() {
  static constexpr std::array<ModelExtent, 2> rows{
      {{"needed", "what the scene needs of the model, by the rules of variants/scene_features.hpp", false},
       {"full", "all of it", true}}};
  return rows;
}

// That of a variant.
const ModelExtent& model_of(const Variant& variant);

}  // namespace warpgrain
