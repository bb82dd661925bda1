#include "variants/searches.hpp"

#include <array>

namespace warpgrain {

std::span<const Search> searches() {
  static constexpr std::array<Search, 1> rows{{
      {"cells", "each work-item walks the 27 cells around its particle", "search/cells.cl"},
  }};
  return rows;
}

}  // namespace warpgrain
