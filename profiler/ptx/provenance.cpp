#include "profiler/ptx/provenance.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <string_view>

#include "profiler/ptx/modifier_reader.hpp"

namespace warpgrain::profiler::ptx {
namespace {

// What these give is no address, whatever they are given.
bool makes_number(const Statement& s) {
  static const std::set<std::string_view> opcodes{"mul",  "mul24", "mad24", "shl",  "shr", "div",
                                                  "rem",  "set",   "setp",  "popc", "clz", "bfind",
                                                  "brev", "bfe",   "sad",   "abs",  "neg", "not"};
  return opcodes.contains(s.opcode);
}

ScalarType accessed_type(const Statement& s) {
  for (auto m = s.modifiers.rbegin(); m != s.modifiers.rend(); ++m)
    if (const auto type = scalar_type(*m)) return *type;
  return bits_type(32);
}

StateSpace accessed_space(const Statement& s) {
  return ModifierReader(s).take_space().value_or(StateSpace::generic);
}

void collect(const Operand& operand, std::vector<std::string_view>& names) {
  if (!operand.name.empty()) names.push_back(operand.name);
  for (const Operand& element : operand.elements) collect(element, names);
}

bool is_store(const Statement& s) { return s.opcode == "st"; }

// Registers that the statement writes; of a store to a call's parameter, that.
std::vector<std::string_view> written_by(const Statement& s) {
  std::vector<std::string_view> names;
  const bool has_result = !s.operands.empty() && s.opcode != "red" && s.opcode != "bra" && s.opcode != "brx";
  if (has_result && (!is_store(s) || accessed_space(s) == StateSpace::parameter))
    collect(s.operands[0], names);
  return names;
}

std::vector<std::string_view> read_by(const Statement& s) {
  std::vector<std::string_view> names;
  for (std::size_t i = 1; i < s.operands.size(); ++i) collect(s.operands[i], names);
  return names;
}

}  // namespace

Provenance::Provenance(const Module& module, const Function& kernel, const MemoryLayout& layout) {
  add_objects(module, kernel, layout);
  follow(kernel);
}

void Provenance::add_objects(const Module& module, const Function& kernel, const MemoryLayout& layout) {
  const bool says_pointers =
      std::any_of(kernel.parameters.begin(), kernel.parameters.end(),
                  [](const Variable& p) { return p.pointer != KernelParameter::Pointer::none; });
  for (std::size_t i = 0; i < kernel.parameters.size(); ++i) {
    const Variable& p = kernel.parameters[i];
    // CUDA's PTX does not say which parameters are pointers.
    const bool may_point = says_pointers ? p.pointer != KernelParameter::Pointer::none : p.bytes == 8;
    parameters_[p.name] = may_point                        ? static_cast<Origin>(i)
                          : p.bytes >= 8 && !says_pointers ? unknown
                                                           : number;
    objects_.push_back({MemoryObject::Kind::parameter, p.name, static_cast<std::uint32_t>(i), 0,
                        p.pointer == KernelParameter::Pointer::constant});
  }
  const auto add = [&](MemoryObject::Kind kind, const Variable& v, std::uint32_t offset, bool read_only) {
    symbols_[v.name] = static_cast<Origin>(objects_.size());
    objects_.push_back({kind, v.name, offset, v.bytes, read_only});
  };
  const auto add_shared = [&](const Variable& v) {
    const auto found = layout.shared_offsets.find(v.name);
    if (v.external && found != layout.shared_offsets.end())
      symbols_[v.name] = symbols_.at(layout.dynamic_shared->name);  // all lie at one place
    else if (found != layout.shared_offsets.end())
      add(MemoryObject::Kind::shared, v, found->second, false);
  };
  // What the launch gives behind the parameters.
  if (layout.dynamic_shared != nullptr) {
    const Variable& v = *layout.dynamic_shared;
    add(MemoryObject::Kind::parameter, v, static_cast<std::uint32_t>(kernel.parameters.size()), false);
  }
  for (const Variable& v : kernel.variables) {
    add_shared(v);
    if (const auto found = layout.local_offsets.find(v.name); found != layout.local_offsets.end())
      add(MemoryObject::Kind::local, v, found->second, false);
  }
  for (const Variable& v : module.variables) {
    add_shared(v);
    if (v.external || (v.space != StateSpace::global && v.space != StateSpace::constant)) continue;
    add(MemoryObject::Kind::variable, v, static_cast<std::uint32_t>(variables_.size()),
        v.space == StateSpace::constant);
    variables_.push_back(&v);
  }
}

// What a choice between both, or their sum, may be.
Provenance::Origin Provenance::join(Origin a, Origin b) {
  if (a == b || b == number) return a;
  return a == number ? b : unknown;
}

Provenance::Origin Provenance::origin_of(const Operand& operand) const {
  if (operand.kind == Operand::Kind::vector || operand.kind == Operand::Kind::pair) {
    Origin all = number;
    for (const Operand& element : operand.elements) all = join(all, origin_of(element));
    return all;
  }
  if (operand.name.empty()) return number;
  if (const auto found = symbols_.find(operand.name); found != symbols_.end()) return found->second;
  if (const auto found = held_.find(operand.name); found != held_.end()) return found->second;
  return parameters_.contains(operand.name) ? unknown : number;  // the parameter's own address
}

Provenance::Origin Provenance::loaded(const Statement& s) const {
  const Origin what_memory_holds = accessed_type(s).bits == 64 ? unknown : number;
  if (s.opcode == "atom" || s.operands.size() < 2 || accessed_space(s) != StateSpace::parameter)
    return what_memory_holds;
  const Operand& address = s.operands[1];
  if (const auto found = parameters_.find(address.name); found != parameters_.end())
    return address.value == 0 ? found->second : what_memory_holds;
  const auto found = held_.find(address.name);
  return found == held_.end() ? number : found->second;
}

Provenance::Origin Provenance::result_of(const Statement& s) const {
  if (s.opcode == "ld" || s.opcode == "ldu" || s.opcode == "atom") return loaded(s);
  if (makes_number(s)) return number;
  // Of a product and a sum, only what is added can be an address.
  const std::size_t first = s.opcode == "mad" || s.opcode == "madc" || s.opcode == "fma" ? 3 : 1;
  Origin all = number;
  for (std::size_t i = first; i < s.operands.size(); ++i) all = join(all, origin_of(s.operands[i]));
  return all;
}

void Provenance::follow(const Function& kernel) {
  std::unordered_map<std::string_view, std::vector<std::size_t>> readers;
  std::deque<std::size_t> work;
  for (std::size_t i = 0; i < kernel.statements.size(); ++i) {
    for (const std::string_view name : read_by(kernel.statements[i])) readers[name].push_back(i);
    work.push_back(i);
  }
  while (!work.empty()) {
    const Statement& statement = kernel.statements[work.front()];
    work.pop_front();
    const Origin origin = result_of(statement);
    if (origin == number) continue;
    for (const std::string_view name : written_by(statement)) {
      Origin& held = held_.emplace(name, number).first->second;
      const Origin joined = join(held, origin);
      if (joined == held) continue;
      held = joined;
      for (const std::size_t reader : readers[name]) work.push_back(reader);
    }
  }
}

std::uint32_t Provenance::object_of(const Operand& address) const {
  const Origin origin = origin_of(address);
  return origin < objects_.size() ? origin : AccessSite::any_object;
}

}  // namespace warpgrain::profiler::ptx
