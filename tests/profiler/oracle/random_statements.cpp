#include "tests/profiler/oracle/random_statements.hpp"

namespace warpgrain::oracle {
namespace {

constexpr int max_depth = 4;

std::string block(const std::string& statements) { return fill("{\n$}\n", {statements}); }

}  // namespace

std::string RandomStatements::new_counter() {
  function_.counters.push_back(fill("c$", {std::to_string(function_.counters.size())}));
  return function_.counters.back();
}

std::string RandomStatements::new_label() { return fill("L$", {std::to_string(function_.n_labels++)}); }

std::string RandomStatements::sequence(const Around& around) {
  std::string text;
  for (auto n = 1 + dice_.below(3); n > 0; --n) text += statement(around);
  return text;
}

std::string RandomStatements::statement(const Around& around) {
  if (--budget_ < 0 || around.depth >= max_depth) return simple(around);
  Around inside = around;
  ++inside.depth;
  switch (dice_.below(16)) {
    case 0:
    case 1:
    case 2:
      return branch(inside);
    case 3:
      return choice(inside);
    case 4:
    case 5:
    case 6:
      return loop(inside);
    case 7:
    case 8:
      return jump(around);
    case 9:
      return region_with_way_out(inside);
    case 10:
      if (!around.may_tangle) return loop(inside);
      return dice_.one_in(2) ? tangle(inside) : loop_entered_by_switch(inside);
    default:
      return simple(around);
  }
}

std::string RandomStatements::simple(const Around& around) {
  const auto word = [&](int depth) { return random_word(dice_, function_, depth); };
  const auto real = [&] { return dice_.one_of(function_.floats); };
  switch (dice_.below(12)) {
    case 0:
      if (!function_.is_kernel) break;
      return fill("out[$ & 3u] $= $;\n", {word(0), dice_.one_of({"+", "^"}), word(1)});
    case 1:
      // What they return differs with the order of lanes, what they leave does not.
      if (!function_.is_kernel) break;
      return fill("$, $);\n",
                  {dice_.one_of({"atomic_add(&sums[0]", "atomic_sub(&sums[0]", "atomic_xor(&sums[1]",
                                 "atomic_or(&sums[2]", "atomic_max(&sums[3]"}),
                   word(1)});
    case 2: {
      if (function_.floats.empty()) break;
      const std::string target = real();
      return fill("$ = clamp($ + (float)($ & 1023u) * 0.25f, -4096.0f, 4096.0f);\n",
                  {target, target, word(1)});
    }
    case 3:
      if (function_.floats.empty()) break;
      return fill("$ = clamp($ - $, -4096.0f, 4096.0f);\n", {real(), real(), real()});
    case 4:
      return fill("t[$ & 3u] = $;\n", {word(0), word(1)});
    case 5:
      return fill("$ += t[$ & 3u];\n", {dice_.one_of(function_.words), word(0)});
    case 6:
      if (dice_.one_in(2)) return jump(around);
      break;
    default:
      break;
  }
  return assignment();
}

std::string RandomStatements::assignment() {
  return fill("$ $ $;\n", {dice_.one_of(function_.words), dice_.one_of({"=", "=", "+=", "^=", "-=", "*="}),
                           random_word(dice_, function_, dice_.one_in(4) ? 3 : 1)});
}

std::string RandomStatements::branch(const Around& around) {
  // Ways out of one arm are what sets policies apart: lanes that stay wait for each other behind the branch,
  // or not before the loop is over.
  const auto arm = [&] {
    if (dice_.one_in(2)) return block(sequence(around));
    return block(fill("$$$", {sequence(around), jump(around), simple(around)}));
  };
  std::string text = fill("if $ $", {random_condition(dice_, function_, dice_.one_in(3) ? 2 : 1), arm()});
  if (dice_.one_in(2)) text += fill("else $", {arm()});
  return text + simple(around);
}

std::string RandomStatements::choice(const Around& around) {
  Around inside = around;
  inside.in_switch = true;
  const std::uint64_t n_cases = 2 + dice_.below(6);
  // Dense cases become tables or chains, sparse ones searches.
  const std::uint64_t stride = dice_.one_in(3) ? 1 + dice_.below(1000) : 1;
  std::string text = fill(
      "switch ($ % $u * $u) {\n",
      {random_word(dice_, function_, 2), std::to_string(n_cases + dice_.below(3)), std::to_string(stride)});
  for (std::uint64_t i = 0; i < n_cases; ++i)
    text += fill("case $u:\n$$",
                 {std::to_string(i * stride), sequence(inside), dice_.one_in(4) ? "" : "break;\n"});
  if (dice_.one_in(2)) text += fill("default:\n$", {sequence(inside)});
  return text + "}\n";
}

std::string RandomStatements::loop(const Around& around) {
  Around inside = around;
  inside.in_loop = true;
  inside.in_switch = false;
  const std::string counter = new_counter();
  // Few trips where loops stand in loops.
  const std::string trips =
      dice_.one_in(4) ? std::to_string(2 + dice_.below(4))
                      : fill("(int)($ % $u)", {random_word(dice_, function_, 1),
                                               std::to_string(2 + dice_.below(around.depth > 1 ? 3 : 6))});
  const std::string body =
      dice_.one_in(2) ? sequence(inside) : fill("$$", {branch(inside), sequence(inside)});
  switch (dice_.below(4)) {
    case 0:
      return fill("$ = $;\nwhile ($-- > 0 && $) $",
                  {counter, trips, counter, random_condition(dice_, function_, 1), block(body)});
    case 1:
      return fill("$ = $;\ndo $while (--$ > 0);\n", {counter, trips, block(body), counter});
    case 2:
      return fill("for ($ = $; ; ) {\nif (--$ < 0) break;\n$}\n", {counter, trips, counter, body});
    default:
      return fill("for ($ = $; $ > 0; --$) $", {counter, trips, counter, counter, block(body)});
  }
}

std::string RandomStatements::jump(const Around& around) {
  std::vector<std::string> ways;
  if (around.in_loop) ways.insert(ways.end(), {"break", "continue", "continue"});
  if (around.may_return) ways.emplace_back("return");
  for (const std::string& label : around.labels) ways.push_back(fill("goto $", {label}));
  if (ways.empty()) return assignment();
  std::string way = dice_.one_of(ways);
  if (way == "return" && !function_.is_kernel) way = fill("return $", {random_word(dice_, function_, 1)});
  return fill("if $ $;\n", {random_condition(dice_, function_, dice_.one_in(3) ? 2 : 1), way});
}

// A goto leads out of whatever is inside.
std::string RandomStatements::region_with_way_out(const Around& around) {
  Around inside = around;
  inside.labels.push_back(new_label());
  return fill("{\n$$$}\n$:;\n", {sequence(inside), jump(inside), sequence(inside), inside.labels.back()});
}

// Labels, some of them inside of loops, and jumps between any two while there is fuel. Loops count in
// variables of their own, so that a lane that comes in from the side ends all the same.
std::string RandomStatements::tangle(const Around& around) {
  std::vector<std::string> labels;
  for (auto n = 2 + dice_.below(3); n > 0; --n) labels.push_back(new_label());
  Around inside = around;
  inside.depth = max_depth;
  std::string text;
  for (const std::string& label : labels) {
    const bool in_loop = dice_.one_in(3);
    inside.in_loop = around.in_loop || in_loop;
    const std::string part =
        fill("$:;\n$if (fuel > 0 && $) { --fuel; goto $; }\n",
             {label, sequence(inside), random_condition(dice_, function_, 1), dice_.one_of(labels)});
    if (!in_loop) {
      text += part;
      continue;
    }
    const std::string counter = new_counter();
    text += fill("for ($ = (int)($ & 3u); $ > 0; --$) {\n$$}\n",
                 {counter, random_word(dice_, function_, 1), counter, counter, simple(inside), part});
  }
  return block(text);
}

std::string RandomStatements::loop_entered_by_switch(const Around& around) {
  Around inside = around;
  inside.in_loop = true;
  inside.depth = max_depth;
  const std::string counter = new_counter();
  return fill(
      "$ = (int)($ & 3u);\nswitch ($ & 3u) {\ncase 0u:\n$do {\n$case 1u:\n$case 2u:\n$} while (--$ > "
      "0);\n}\n",
      {counter, random_word(dice_, function_, 1), random_word(dice_, function_, 1), simple(around),
       sequence(inside), sequence(inside), simple(inside), counter});
}

}  // namespace warpgrain::oracle
