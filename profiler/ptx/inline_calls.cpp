#include "profiler/ptx/inline_calls.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/ptx/emit_printf.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using Names = std::unordered_map<std::string, std::string>;

struct Call {
  std::string callee;
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
    active_.pop_back();
  }

  void copy_statement(const Statement& original, const Names& names, const std::string& return_label) {
    Statement statement = original;
    if (statement.guard) rename(statement.guard->predicate, names);
    for (Operand& operand : statement.operands) rename(operand, names);
    if (statement.opcode == "call") return expand(statement);
    if (statement.opcode == "ret" && !return_label.empty()) {
      Operand target;
      target.name = return_label;
      statement.opcode = "bra";
      statement.modifiers.clear();
      statement.operands = {target};
    }
    if (flat_.statements.size() >= max_statements)
      throw_input_error(place(where_, module_, original), "calls put in place",
                        fmt::format("at most {} instructions", max_statements));
    flat_.statements.push_back(std::move(statement));
  }

  void expand(Statement& statement) {
    const Call call = read_call(statement);
    const Function* callee = module_.find_function(call.callee);
    if (is_printf(call.callee) && !statement.guard) return flat_.statements.push_back(statement);
    if (!callee || !callee->has_body)
      throw_input_error(place(where_, module_, statement),
                        fmt::format("call of '{}', which has no body here", call.callee),
                        "functions of this module");
    if (statement.guard)
      throw_input_error(place(where_, module_, statement), fmt::format("'{}'", statement.text),
                        "a call without a predicate");
    Names bound;
    bind(callee->results, call.results, statement, bound);
    bind(callee->parameters, call.arguments, statement, bound);

    const std::string suffix = fmt::format("@{}", ++calls_);
    const std::string return_label = fmt::format("{}.return{}", call.callee, suffix);
    statement.operands.clear();
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
    if (operand == end || operand->kind != Operand::Kind::name || operand->name.starts_with('%'))
      throw_input_error(place(where_, module_, statement), fmt::format("'{}'", statement.text),
                        "a call of a function by name");
    call.callee = (operand++)->name;
    if (operand != end && operand->kind == Operand::Kind::list) call.arguments = (operand++)->elements;
    return call;
  }

  void bind(const std::vector<Variable>& formal, const std::vector<Operand>& actual,
            const Statement& statement, Names& bound) const {
    bool fits = formal.size() == actual.size();
    for (std::size_t i = 0; fits && i < formal.size(); ++i) {
      const auto variable = std::find_if(flat_.variables.begin(), flat_.variables.end(),
                                         [&](const Variable& v) { return v.name == actual[i].name; });
      fits = variable != flat_.variables.end() && variable->bytes >= formal[i].bytes;
      bound[formal[i].name] = actual[i].name;
    }
    if (!fits)
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
  int calls_ = 0;
};

}  // namespace

Function inline_calls(const Module& module, const Function& entry, std::string_view where) {
  return Inliner(module, where).run(entry);
}

}  // namespace warpgrain::profiler::ptx
