#include "profiler/ptx/inline_calls.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "core/error.hpp"
#include "profiler/ptx/control_flow.hpp"
#include "profiler/ptx/emit_printf.hpp"
#include "profiler/ptx/missing_function.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {
namespace {

// What CUDA's assert calls where it fails; it does not come back.
constexpr std::string_view assertion_failure = "__assertfail";

using Names = std::unordered_map<std::string, std::string>;

struct Call {
  std::string callee;
  std::string targets;  // the label of a .calltargets or .callprototype behind a call through a pointer
  std::vector<Operand> results, arguments;
};

class Inliner {
 public:
  Inliner(const Module& module, std::string_view where) : module_(module), where_(where) {}

  Function run(const Function& entry) {
    flat_ = entry;
    flat_.statements.clear();
    flat_.labels.clear();
    flat_.branch_tables.clear();
    flat_.registers.clear();
    flat_.variables.clear();
    copy(entry, {}, "", "");
    return std::move(flat_);
  }

 private:
  // Appends the body of `function`. Names of its own get `suffix`; `bound` says what its parameters and
  // results are called. A `ret` leads to `return_label`, unless that is empty.
  void copy(const Function& function, const Names& bound, const std::string& suffix,
            const std::string& return_label) {
    if (std::find(active_.begin(), active_.end(), function.name) != active_.end())
      throw_input_error(place(where_, function.line),
                        fmt::format("function '{}' calls itself", function.name), "no recursion");
    active_.push_back(function.name);
    const Function* const caller = std::exchange(current_, &function);
    Names names = bound;
    for (const auto& [name, type] : function.registers) {
      flat_.registers.emplace_back(name + suffix, type);
      names.emplace(name, name + suffix);
    }
    for (Variable variable : function.variables) {
      names.emplace(variable.name, variable.name + suffix);
      variable.name += suffix;
      flat_.variables.push_back(std::move(variable));
    }
    for (const auto& [label, unused] : function.labels) names.emplace(label, label + suffix);
    for (const auto& [label, targets] : function.branch_tables) {
      names.emplace(label, label + suffix);
      auto& table = flat_.branch_tables[label + suffix];
      for (const std::string& target : targets) table.push_back(target + suffix);
    }

    std::unordered_map<std::size_t, std::vector<std::string>> labels_at;
    for (const auto& [label, index] : function.labels) labels_at[index].push_back(label + suffix);
    for (std::size_t i = 0; i <= function.statements.size(); ++i) {
      for (const std::string& label : labels_at[i]) flat_.labels[label] = flat_.statements.size();
      if (i < function.statements.size()) copy_statement(function.statements[i], names, return_label);
    }
    current_ = caller;
    active_.pop_back();
  }

  void copy_statement(const Statement& original, const Names& names, const std::string& return_label) {
    Statement statement = original;
    if (statement.guard) rename(statement.guard->predicate, names);
    for (Operand& operand : statement.operands) rename(operand, names);
    if (statement.opcode == "call") return expand(statement);
    if (statement.opcode == "ret" && !return_label.empty()) {
      statement.opcode = "bra";
      statement.modifiers.clear();
      statement.operands = {label_operand(return_label)};
    }
    if (flat_.statements.size() >= max_statements)
      throw_input_error(place(where_, module_, original), "calls put in place",
                        fmt::format("at most {} instructions", max_statements));
    flat_.statements.push_back(std::move(statement));
  }

  void expand(Statement& statement) {
    const Call call = read_call(statement);
    const Function* callee = module_.find_function(call.callee);
    if (is_printf(call.callee)) return flat_.statements.push_back(statement);
    if (call.callee == assertion_failure) {
      statement.opcode = "trap";
      statement.modifiers.clear();
      statement.operands.clear();
      return flat_.statements.push_back(statement);
    }
    if (!callee && is_register(call.callee)) return expand_indirect(statement, call);
    if (!callee || !callee->has_body)
      throw_input_error(place(where_, module_, statement), missing_function(call.callee),
                        "functions of this module");
    Names bound;
    bind(callee->results, call.results, statement, bound);
    bind(callee->parameters, call.arguments, statement, bound);

    const std::string suffix = fmt::format("@{}", ++calls_);
    const std::string return_label = fmt::format("{}.return{}", call.callee, suffix);
    statement.operands.clear();
    // A call with a predicate is a branch: over the function, where the predicate is false.
    if (statement.guard) {
      statement.opcode = "bra";
      statement.modifiers.clear();
      statement.guard->negated = !statement.guard->negated;
      statement.operands = {label_operand(return_label)};
    }
    flat_.statements.push_back(statement);
    copy(*callee, bound, suffix, return_label);
    flat_.labels[return_label] = flat_.statements.size();
  }

  // `(results), name, (arguments)`, either list may be missing.
  Call read_call(const Statement& statement) const {
    Call call;
    auto operand = statement.operands.begin();
    const auto end = statement.operands.end();
    if (operand != end && operand->kind == Operand::Kind::list) call.results = (operand++)->elements;
    if (operand == end || operand->kind != Operand::Kind::name)
      throw_input_error(place(where_, module_, statement), fmt::format("'{}'", statement.text),
                        "a call of a function");
    call.callee = (operand++)->name;
    if (operand != end && operand->kind == Operand::Kind::list) call.arguments = (operand++)->elements;
    if (operand != end) call.targets = operand->name;
    return call;
  }

  bool is_register(const std::string& name) const {
    return std::ranges::any_of(flat_.registers, [&](const auto& r) { return r.first == name; });
  }

  // The call becomes a branch to copies of the functions that it may reach: those that its .calltargets name,
  // else all of the module whose address is taken and whose parameters fit.
  void expand_indirect(Statement& statement, const Call& call) {
    if (statement.guard)
      throw_input_error(place(where_, module_, statement), fmt::format("'{}'", statement.text),
                        "a call through a pointer without a predicate");
    const std::vector<const Function*> callees = candidates(call);
    if (callees.empty())
      throw_input_error(place(where_, module_, statement), fmt::format("'{}'", statement.text),
                        "a function of this module whose address is taken and whose parameters fit");
    const int number = ++calls_;
    const std::string return_label = fmt::format("call.return@{}", number);
    const auto entry_of = [&](const Function* f) { return fmt::format("{}.entry@{}", f->name, number); };
    statement.operands.resize(1);
    statement.operands[0] = label_operand(call.callee);
    for (const Function* callee : callees) {
      statement.operands.push_back(label_operand(entry_of(callee)));
      statement.operands.back().value = *module_.function_address(callee->name);
    }
    flat_.statements.push_back(statement);
    for (const Function* callee : callees) {
      Names bound;
      bind(callee->results, call.results, statement, bound);
      bind(callee->parameters, call.arguments, statement, bound);
      flat_.labels[entry_of(callee)] = flat_.statements.size();
      copy(*callee, bound, fmt::format("@{}", ++calls_), return_label);
    }
    flat_.labels[return_label] = flat_.statements.size();
  }

  std::vector<const Function*> candidates(const Call& call) const {
    const auto targets = current_->call_targets.find(call.targets);
    std::vector<const Function*> found;
    for (const Function& function : module_.functions) {
      const bool named = targets == current_->call_targets.end()
                             ? address_is_taken(function.name)
                             : std::ranges::find(targets->second, function.name) != targets->second.end();
      // A function that is running is not reached again: recursion is caught when it happens.
      const bool running = std::ranges::find(active_, function.name) != active_.end();
      if (named && !running && !function.is_entry && ends_by_return(function) &&
          fits(function.results, call.results) && fits(function.parameters, call.arguments))
        found.push_back(&function);
    }
    return found;
  }

  static bool ends_by_return(const Function& function) {
    return function.has_body && !function.statements.empty() && is_terminator(function.statements.back()) &&
           !function.statements.back().guard;
  }

  bool address_is_taken(const std::string& name) const {
    const auto names_it = [&](const Operand& operand) { return operand.name == name; };
    const auto takes_it = [&](const Statement& s) {
      return s.opcode != "call" && std::ranges::any_of(s.operands, names_it);
    };
    return std::ranges::any_of(
               module_.functions,
               [&](const Function& f) { return std::ranges::any_of(f.statements, takes_it); }) ||
           std::ranges::any_of(module_.variables, [&](const Variable& v) {
             return std::ranges::any_of(v.relocations, [&](const Relocation& r) { return r.symbol == name; });
           });
  }

  const Variable* variable_of(const Operand& actual) const {
    const auto found = std::ranges::find(flat_.variables, actual.name, &Variable::name);
    return found == flat_.variables.end() ? nullptr : &*found;
  }

  bool fits(const std::vector<Variable>& formal, const std::vector<Operand>& actual) const {
    if (formal.size() != actual.size()) return false;
    for (std::size_t i = 0; i < formal.size(); ++i) {
      const Variable* variable = variable_of(actual[i]);
      if (variable == nullptr || variable->bytes != formal[i].bytes) return false;
    }
    return true;
  }

  static Operand label_operand(const std::string& name) {
    Operand operand;
    operand.name = name;
    return operand;
  }

  void bind(const std::vector<Variable>& formal, const std::vector<Operand>& actual,
            const Statement& statement, Names& bound) const {
    bool are_bound = formal.size() == actual.size();
    for (std::size_t i = 0; are_bound && i < formal.size(); ++i) {
      const Variable* variable = variable_of(actual[i]);
      are_bound = variable != nullptr && variable->bytes >= formal[i].bytes;
      bound[formal[i].name] = actual[i].name;
    }
    if (!are_bound)
      throw_input_error(place(where_, module_, statement), fmt::format("'{}'", statement.text),
                        "a .param variable for each parameter of the function");
  }

  static void rename(std::string& name, const Names& names) {
    if (const auto found = names.find(name); found != names.end()) name = found->second;
  }

  static void rename(Operand& operand, const Names& names) {
    rename(operand.name, names);
    for (Operand& element : operand.elements) rename(element, names);
  }

  static constexpr std::size_t max_statements = std::size_t{1} << 20;
  const Module& module_;
  std::string_view where_;
  Function flat_;
  std::vector<std::string> active_;
  const Function* current_ = nullptr;  // whose body is being copied
  int calls_ = 0;
};

}  // namespace

Function inline_calls(const Module& module, const Function& entry, std::string_view where) {
  return Inliner(module, where).run(entry);
}

}  // namespace warpgrain::profiler::ptx
