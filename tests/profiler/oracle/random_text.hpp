#pragma once
// What the parts of the generator share: dice, text, and what a function under construction has to offer.

#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::oracle {

// The standard fixes mt19937_64's numbers, but not those of its distributions.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  bool one_in(std::uint64_t n) { return below(n) == 0; }
  std::string number_below(std::uint64_t n) { return std::to_string(below(n)); }
  const std::string& one_of(const std::vector<std::string>& values) { return values[below(values.size())]; }

 private:
  std::mt19937_64 random_;
};

// `pattern` with its $s replaced by the parts, in turn. Parts in braces are made from left to right,
// arguments of a function in any order: so the same dice give the same text with every compiler.
std::string fill(std::string_view pattern, std::initializer_list<std::string> parts);

// Of the kernel, or of a function that it calls.
struct FunctionText {
  bool is_kernel = false;
  std::vector<std::string> words;     // names of uint variables that may be assigned to
  std::vector<std::string> readable;  // further uint expressions: ids, parameters
  std::vector<std::string> floats;    // hold multiples of 1/4 below 2^20 in magnitude
  std::vector<std::string> callable;  // functions of two uints and of the input
  std::vector<std::string> counters;  // of its loops; declared when its text is complete
  std::uint64_t n_labels = 0;
};

// Expressions; `depth` bounds their nesting.
std::string random_word(Dice& dice, const FunctionText& function, int depth);
std::string random_condition(Dice& dice, const FunctionText& function, int depth);

}  // namespace warpgrain::oracle
