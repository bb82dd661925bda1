#include "tests/profiler/oracle/random_text.hpp"

namespace warpgrain::oracle {
namespace {

std::string leaf(Dice& dice, const FunctionText& function) {
  switch (dice.below(8)) {
    case 0:
      return dice.number_below(16) + "u";
    case 1:
      return dice.number_below(std::uint64_t{1} << 32) + "u";
    case 2:
      return fill("in[$ & 63u]", {dice.one_of(function.words)});
    case 3:
      return dice.one_of(function.readable);
    default:
      return dice.one_of(function.words);
  }
}

// A word that is likely to differ between lanes, and from pass to pass.
std::string varying(Dice& dice, const FunctionText& function) {
  switch (dice.below(4)) {
    case 0:
      return fill("in[$ & 63u]", {dice.one_of(function.words)});
    case 1:
      return fill("($ >> $u)", {dice.one_of(function.words), dice.number_below(8)});
    case 2:
      return fill("($ + $)", {dice.one_of(function.words), leaf(dice, function)});
    default:
      return dice.one_of(function.words);
  }
}

}  // namespace

std::string fill(std::string_view pattern, std::initializer_list<std::string> parts) {
  std::string text;
  auto part = parts.begin();
  for (const char c : pattern) {
    if (c == '$') {
      text += *part++;
    } else {
      text += c;
    }
  }
  return text;
}

std::string random_word(Dice& dice, const FunctionText& function, int depth) {
  if (depth <= 0) return leaf(dice, function);
  const auto word = [&] { return random_word(dice, function, depth - 1); };
  switch (dice.below(23)) {
    case 0:
    case 1:
    case 2:
      return fill("($ + $)", {word(), word()});
    case 3:
      return fill("($ - $)", {word(), word()});
    case 4:
      return fill("($ * $)", {word(), word()});
    case 5:
      return fill("($ $ $)", {word(), dice.one_of({"&", "|", "^"}), word()});
    case 6:
      return fill("($ $ ($ & 31u))", {word(), dice.one_of({"<<", ">>"}), word()});
    case 7:
      return fill("($ $ ($ | 1u))", {word(), dice.one_of({"/", "%"}), word()});
    case 8:
      return fill("(uint)((int)($ >> 1) $ (int)(($ & 255u) | 1u))",
                  {word(), dice.one_of({"/", "%"}), word()});
    case 9:
      return fill("$($, $)",
                  {dice.one_of({"min", "max", "mul_hi", "rotate", "abs_diff", "hadd"}), word(), word()});
    case 10:
      return fill("$($)", {dice.one_of({"popcount", "clz"}), word()});
    case 11:
      return fill("(uint)($)$", {dice.one_of({"uchar", "char", "ushort", "short", "int"}), word()});
    case 12:
      return fill("(uint)(((ulong)$ * $) >> $u)", {word(), word(), dice.number_below(40)});
    case 13:
      return fill("(uint)((long)(int)$ $ (long)(int)$)", {word(), dice.one_of({"+", "-"}), word()});
    case 14:
    case 15:
    case 16:
      return fill("($ ? $ : $)", {random_condition(dice, function, depth - 1), word(), word()});
    case 17:
      return fill("(uint)convert_$_sat((int)$)", {dice.one_of({"uchar", "ushort"}), word()});
    case 18:
      if (function.floats.empty()) return leaf(dice, function);
      return fill("(uint)(int)$", {dice.one_of(function.floats)});
    case 19:
      if (function.callable.empty()) return leaf(dice, function);
      return fill("$($, $, in)", {dice.one_of(function.callable), word(), word()});
    case 20:
      return fill("bitselect($, $, $)", {word(), word(), word()});
    default:
      return leaf(dice, function);
  }
}

std::string random_condition(Dice& dice, const FunctionText& function, int depth) {
  const auto word = [&] { return random_word(dice, function, depth - 1); };
  const auto condition = [&] { return random_condition(dice, function, depth - 1); };
  if (depth > 0) {
    switch (dice.below(9)) {
      case 0:
        return fill("($ && $)", {condition(), condition()});
      case 1:
        return fill("($ || $)", {condition(), condition()});
      case 2:
        return fill("(!$)", {condition()});
      case 3:
        if (function.floats.empty()) break;
        return fill("($ $ $.0f)",
                    {dice.one_of(function.floats), dice.one_of({"<", ">="}), dice.number_below(200)});
      default:
        break;
    }
  }
  // Mostly such that lanes are of several minds.
  const auto left = [&] { return varying(dice, function); };
  switch (dice.below(6)) {
    case 0:
      return fill("($ < $)", {left(), word()});
    case 1:
      return fill("((int)$ > (int)$)", {left(), word()});
    case 2:
      return fill("($ % $u < $u)", {left(), dice.one_of({"3", "4", "5", "7"}), dice.one_of({"1", "2"})});
    default:
      return fill("(($ & $u) $ $u)", {left(), dice.one_of({"1", "3", "6", "7"}),
                                      dice.one_of({"==", "!=", "<"}), dice.number_below(4)});
  }
}

}  // namespace warpgrain::oracle
