#include "profiler/sass/predicates.hpp"

#include <array>

namespace warpgrain::profiler::sass {
namespace {

enum class Value : std::uint8_t { unreached, no, yes, unknown };
using PredicateValues = std::array<Value, 8>;  // by predicate

PredicateValues no_predicate_known() {
  PredicateValues values;
  values.fill(Value::unknown);
  values[always] = Value::yes;
  return values;
}

// Lanes of both come on. Whether that changes anything.
bool join_predicates(PredicateValues& values, const PredicateValues& others) {
  bool changed = false;
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (values[p] == others[p] || values[p] == Value::unknown || others[p] == Value::unreached) continue;
    values[p] = values[p] == Value::unreached ? others[p] : Value::unknown;
    changed = true;
  }
  return changed;
}

void write_predicates(const Instruction& i, PredicateValues& values) {
  for (std::size_t p = 0; p < always; ++p) {
    if ((i.predicates_written >> p & 1U) == 0) continue;
    const bool known = i.constant_predicate >= 0 && i.guard == always && !i.guard_negated;
    values[p] = !known ? Value::unknown : i.constant_predicate != 0 ? Value::yes : Value::no;
  }
}

// Uniform instructions run under predicates of their own.
bool has_plain_guard(const Instruction& i) {
  constexpr unsigned first_uniform = 0x080, last_uniform = 0x0BF;
  const unsigned number = i.opcode & 0x1FFU;
  return number < first_uniform || number > last_uniform;
}

// The one predicate that the guard at the end of a block asks; `always` where it asks none or two.
std::uint8_t asked(const Instruction& i) {
  if (i.if_divergent || i.uniform_condition) return always;
  if (i.condition == always && !i.condition_negated) return i.guard;
  return i.guard == always && !i.guard_negated ? i.condition : always;
}

bool asks_negated(const Instruction& i) { return i.guard == always ? i.condition_negated : i.guard_negated; }

class PredicateFinder {
 public:
  explicit PredicateFinder(const CodeGraph& code) : code_(code), at_(code.blocks.size()) {
    for (PredicateValues& values : at_) values.fill(Value::unreached);
  }

  std::vector<PredicateRule> find() {
    flow();
    std::vector<PredicateRule> rules(code_.instructions.size(), PredicateRule::unknown);
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) {
      PredicateValues values = at_[b];
      for (std::uint32_t k = code_.blocks[b].first; k < code_.blocks[b].last; ++k) {
        rules[k] = rule_of(code_.blocks[b], k, values);
        write_predicates(code_.instructions[k], values);
      }
    }
    return rules;
  }

 private:
  void come(std::uint32_t block, const PredicateValues& values) {
    if (block == no_code) return;
    if (join_predicates(at_[block], values)) open_.push_back(block);
  }

  void flow() {
    come(0, no_predicate_known());
    while (!open_.empty()) {
      const std::uint32_t b = open_.back();
      open_.pop_back();
      const CodeBlock& block = code_.blocks[b];
      PredicateValues values = at_[b];
      for (std::uint32_t k = block.first; k < block.last; ++k)
        write_predicates(code_.instructions[k], values);
      leave(block, values);
    }
  }

  void leave(const CodeBlock& block, const PredicateValues& values) {
    switch (block.end) {
      case End::exit:
      case End::ret:
        return;
      case End::call:
        come(block.target, no_predicate_known());
        come(block.next, no_predicate_known());
        return;
      case End::indirect:
        for (const std::uint32_t to : block.table) come(to, values);
        return;
      case End::guard: {
        const Instruction& guard = code_.last_of(block);
        const bool calls = block.guarded == Flow::call;
        if (block.guarded == Flow::branch) come(block.target, behind(guard, values, true));
        if (calls) come(block.target, no_predicate_known());
        come(block.next, calls ? no_predicate_known() : behind(guard, values, false));
        return;
      }
      default:
        come(block.next, values);
    }
  }

  static PredicateValues behind(const Instruction& guard, PredicateValues values, bool taken) {
    const std::uint8_t predicate = asked(guard);
    if (predicate != always) values[predicate] = taken != asks_negated(guard) ? Value::yes : Value::no;
    return values;
  }

  PredicateRule rule_of(const CodeBlock& block, std::uint32_t k, const PredicateValues& values) const {
    const Instruction& i = code_.instructions[k];
    if (i.guard == always) return i.guard_negated ? PredicateRule::off : PredicateRule::on;
    if (!has_plain_guard(i)) return PredicateRule::unknown;
    const Value value = values[i.guard];
    if (value == Value::yes || value == Value::no)
      return (value == Value::yes) != i.guard_negated ? PredicateRule::on : PredicateRule::off;
    const Instruction& last = code_.last_of(block);
    if (block.end != End::guard || asked(last) != i.guard) return PredicateRule::unknown;
    for (std::uint32_t between = k; between + 1 < block.last; ++between)
      if ((code_.instructions[between].predicates_written >> i.guard & 1U) != 0)
        return PredicateRule::unknown;
    return i.guard_negated == asks_negated(last) ? PredicateRule::taken : PredicateRule::not_taken;
  }

  const CodeGraph& code_;
  std::vector<PredicateValues> at_;  // [blocks of the code]: where it begins
  std::vector<std::uint32_t> open_;
};

}  // namespace

std::vector<PredicateRule> find_predicates(const CodeGraph& code) { return PredicateFinder(code).find(); }

}  // namespace warpgrain::profiler::sass
