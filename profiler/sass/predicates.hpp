#pragma once
// What is known of the predicates that instructions of the machine code run under.

#include <cstdint>
#include <vector>

#include "profiler/sass/code_graph.hpp"

namespace warpgrain::profiler::sass {

enum class PredicateRule : std::uint8_t {
  on,         // true for all lanes that come to it, or none is asked for
  off,        // false for all of them
  taken,      // true for the lanes that take the guard at the end of the block
  not_taken,  // for the others
  unknown
};

// [instructions]. A predicate is that of a guard as long as nothing writes it; behind a guard all lanes of
// one way have the same; and some are written as constants.
std::vector<PredicateRule> find_predicates(const CodeGraph& code);

}  // namespace warpgrain::profiler::sass
