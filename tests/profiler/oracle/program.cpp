#include "tests/profiler/oracle/program.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "tests/profiler/oracle/step_decoder.hpp"
#include "tests/profiler/oracle/symbols.hpp"

namespace warpgrain::oracle {
namespace {

// What it prints is nothing that lanes see.
bool is_printf(const ptx::Statement& statement) {
  return std::any_of(statement.operands.begin(), statement.operands.end(), [](const ptx::Operand& operand) {
    return operand.name == "printf" || operand.name == "vprintf";
  });
}

class Decoder {
 public:
  Decoder(const ptx::Module& module, const ptx::Function& kernel)
      : module_(module), module_names_(lay_out_module(module, kernel, program_)) {}

  Program run(const ptx::Function& kernel) {
    copy(kernel, module_names_, nullptr);
    return std::move(program_);
  }

 private:
  Place here() const { return static_cast<Place>(program_.steps.size()); }

  // Appends a copy of the function. The places of its `ret`s are added to `returns`; of the kernel, that is
  // null, and lanes end there.
  void copy(const ptx::Function& function, Names names, std::vector<Place>* returns) {
    if (++depth_ > 64) throw UnknownInstruction("recursion");
    lay_out_function(function, program_, names);
    std::vector<Place> places;  // of the function's statements, and of its end
    std::vector<std::pair<Place, const ptx::Statement*>> jumps;
    for (const ptx::Statement& statement : function.statements) {
      places.push_back(here());
      if (statement.opcode == "bra" || statement.opcode == "brx") jumps.emplace_back(here(), &statement);
      append(statement, names, returns);
    }
    places.push_back(here());
    for (const auto& [place, statement] : jumps) {
      const auto place_of = [&](const std::string& label) { return places[function.labels.at(label)]; };
      Step& step = program_.steps[place];
      if (statement->opcode == "bra") {
        step.to.insert(step.to.begin(), place_of(statement->operands.at(0).name));
        continue;
      }
      for (const std::string& label : function.branch_tables.at(statement->operands.at(1).name)) {
        step.table.push_back(place_of(label));
        if (std::find(step.to.begin(), step.to.end(), step.table.back()) == step.to.end())
          step.to.push_back(step.table.back());
      }
    }
    --depth_;
  }

  void append(const ptx::Statement& statement, const Names& names, std::vector<Place>* returns) {
    const Place place = here();
    program_.steps.push_back(decode_step(statement, names));
    const std::string& opcode = statement.opcode;
    const bool ends = opcode == "ret" || opcode == "exit" || opcode == "trap";
    const bool jumps = opcode == "bra" || opcode == "brx";
    if (opcode == "call") return call(statement, names);
    Step& step = program_.steps.back();
    if (ends && opcode == "ret" && returns != nullptr) {
      returns->push_back(place);
    } else if (ends) {
      step.to.push_back(end_of_lane);
    }
    if (statement.guard || !(ends || jumps)) step.to.push_back(place + 1);
  }

  void call(const ptx::Statement& statement, const Names& names) {
    program_.steps.back().to = {here()};
    if (statement.guard) refuse(statement, "a call with a predicate");
    std::vector<const ptx::Operand*> lists;
    const ptx::Function* callee = nullptr;
    std::size_t arguments_at = 0;
    for (const ptx::Operand& operand : statement.operands) {
      if (operand.kind == ptx::Operand::Kind::list) {
        lists.push_back(&operand);
      } else {
        callee = module_.find_function(operand.name);
        arguments_at = lists.size();
      }
    }
    if (is_printf(statement)) return;
    if (callee == nullptr || !callee->has_body) refuse(statement, "a function without a body here");
    Names inside = module_names_;
    const auto bind = [&](const std::vector<ptx::Variable>& formal, std::size_t list) {
      for (std::size_t i = 0; i < formal.size(); ++i)
        inside[formal[i].name] = names.at(lists.at(list)->elements.at(i).name);
    };
    bind(callee->results, 0);
    bind(callee->parameters, arguments_at);
    std::vector<Place> returns;
    copy(*callee, inside, &returns);
    for (const Place place : returns) {
      std::vector<Place>& to = program_.steps[place].to;
      to.insert(to.begin(), here());
    }
  }

  const ptx::Module& module_;
  Program program_;
  Names module_names_;
  int depth_ = 0;
};

}  // namespace

Program decode(const ptx::Module& module, const ptx::Function& kernel) {
  Program program = Decoder(module, kernel).run(kernel);
  const auto end = static_cast<Place>(program.steps.size());
  for (Step& step : program.steps)
    for (std::vector<Place>* places : {&step.to, &step.table})
      std::replace(places->begin(), places->end(), end_of_lane, end);
  return program;
}

}  // namespace warpgrain::oracle
