#pragma once
// Which cases a sweep has.

#include <cstddef>
#include <string>
#include <vector>

#include "variants/axes.hpp"

namespace warpgrain::cli {

// Every combination of the values named that makes sense, in table order. Each entry of `axis_options` is
// "name=value,value" or "name=all"; an axis that is not named stays at its default. Without any entry: every
// value of every axis once (one_value_at_a_time). Throws InputError for a name or value that there is not,
// for an axis named twice, and with the reason where no combination makes sense.
std::vector<Variant> swept_variants(const std::vector<std::string>& axis_options);

// Every value of every axis once, of the axes that can change results: not those that only say how particles
// and cells lie in memory, how work is dealt out, or what a scene does without.
std::vector<Variant> variants_that_compute_differently();

// "I/N": the I-th of N parts, I from 1.
struct Shard {
  std::size_t index = 1, count = 1;
  static Shard parse(const std::string& text);  // throws InputError
  // Whether the case with this position in the whole sweep is this shard's.
  bool has(std::size_t position) const { return position % count == index - 1; }
};

// The variant's name as a file name: branchy-cells-cell-fp32-default.
std::string file_stem(const Variant& variant);

}  // namespace warpgrain::cli
