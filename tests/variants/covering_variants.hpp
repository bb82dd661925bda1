#pragma once
// Few variants that have every pair of values of two axes, for tests that cannot afford all combinations: a
// kernel that breaks another one breaks it in a pair.

#include <string>
#include <vector>

#include "variants/axes.hpp"

namespace warpgrain {

// Sensible variants such that each pair of values that goes together in some of them is in one.
std::vector<Variant> covering_variants();

// A variant's name as GoogleTest takes it.
std::string test_name(const Variant& variant);

}  // namespace warpgrain
