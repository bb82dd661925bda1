#pragma once
// The searches for contacts: one row here and one .cl file in kernels/search/, which applies any law of
// kernels/contact/.

#include <span>
#include <string_view>

#include "variants/axes.hpp"

namespace warpgrain {

struct Search {
  std::string_view name;  // value of the axis `search`
  std::string_view summary;
  std::string_view file;  // in kernels/
};

std::span<const Search> searches();
// The search of a variant.
const Search& search_of(const Variant& variant);

}  // namespace warpgrain
