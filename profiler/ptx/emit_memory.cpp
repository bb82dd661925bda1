// Loads, stores, atomic operations and fences.

#include "profiler/ptx/instruction_facts.hpp"
#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

struct Access {
  ScalarType type;
  unsigned width = 1;  // elements
  bool is_volatile = false;
  bool is_ordered = false;
  AccessSpace space = AccessSpace::generic;
};

AccessSpace take_space(Emitter& e) {
  switch (e.modifiers().take_space().value_or(StateSpace::generic)) {
    case StateSpace::generic:
      break;
    case StateSpace::global:
      return AccessSpace::global;
    case StateSpace::shared:
      return AccessSpace::shared;
    case StateSpace::constant:
      return AccessSpace::constant;
    case StateSpace::local:
      return AccessSpace::local;
    case StateSpace::parameter:
      return AccessSpace::parameter;
  }
  return AccessSpace::generic;
}

// Line and object are filled in by the check.
AccessSite site_of(const Access& access, AccessKind kind) {
  AccessSite site;
  site.kind = kind;
  site.space = access.space;
  site.element_bytes = static_cast<std::uint8_t>(access.type.bytes());
  site.bytes = static_cast<std::uint8_t>(access.width * access.type.bytes());
  site.ordered = access.is_ordered;
  return site;
}

// Cache operators change no value. Ordered accesses are kept from being moved or merged; the host orders
// them.
Access take_access(Emitter& e) {
  ModifierReader& modifiers = e.modifiers();
  Access access;
  const std::string_view order = modifiers.take_one_of({"volatile", "relaxed", "acquire", "release", "weak"});
  access.is_volatile = !order.empty();
  access.is_ordered = !order.empty() && order != "volatile" && order != "weak";
  modifiers.take_one_of({"cta", "gpu", "sys"});
  access.space = take_space(e);
  modifiers.take_one_of({"ca", "cg", "cs", "lu", "cv", "wb", "wt"});
  modifiers.take("nc");
  modifiers.drop_prefixed("L1::");
  modifiers.drop_prefixed("L2::");
  const std::string_view vector = modifiers.take_one_of({"v2", "v4"});
  access.width = vector.empty() ? 1 : vector == "v2" ? 2 : 4;
  access.type = e.take_type();
  return access;
}

// Whether the graph lists the access, so that the trace has a place for it.
void trace_if_listed(Emitter& e, Value* pointer) {
  if (instruction_facts(e.statement()).accessed_bytes > 0) e.trace_access(pointer);
}

// The elements of an access lie one behind the other.
Value* element_pointer(Emitter& e, Value* pointer, const Access& access, unsigned index) {
  return index == 0 ? pointer : e.ir.CreateConstInBoundsGEP1_64(e.type(access.type), pointer, index);
}

const Operand& element(Emitter& e, const Operand& operand, const Access& access, unsigned index) {
  if (access.width == 1) return operand;
  if (operand.kind != Operand::Kind::vector || operand.elements.size() != access.width)
    e.refuse("a vector of that width");
  return operand.elements[index];
}

void emit_load(Emitter& e) {
  const Access access = take_access(e);
  Value* pointer = e.pointer(e.operand(1));
  trace_if_listed(e, pointer);
  pointer = e.checked(pointer, e.operand(1), site_of(access, AccessKind::load));
  // All are read before any is written: an element may be the address register.
  Value* values[4] = {};
  for (unsigned i = 0; i < access.width; ++i)
    values[i] = e.ir.CreateAlignedLoad(e.type(access.type), element_pointer(e, pointer, access, i),
                                       llvm::Align(access.type.bytes()), access.is_volatile);
  for (unsigned i = 0; i < access.width; ++i)
    e.write(element(e, e.operand(0), access, i), values[i], access.type);
}

void emit_store(Emitter& e) {
  const Access access = take_access(e);
  Value* pointer = e.pointer(e.operand(0));
  trace_if_listed(e, pointer);
  std::vector<Value*> values;
  for (unsigned i = 0; i < access.width; ++i)
    values.push_back(e.read(element(e, e.operand(1), access, i), access.type));
  pointer = e.checked(pointer, e.operand(0), site_of(access, AccessKind::store), values);
  for (unsigned i = 0; i < access.width; ++i)
    e.ir.CreateAlignedStore(values[i], element_pointer(e, pointer, access, i),
                            llvm::Align(access.type.bytes()), access.is_volatile);
}

Value* atomic_operation(Emitter& e, std::string_view operation, Value* pointer, ScalarType type,
                        std::size_t first) {
  using Rmw = llvm::AtomicRMWInst;
  const auto order = llvm::AtomicOrdering::SequentiallyConsistent;
  const llvm::Align align(type.bytes());
  if (operation == "cas") {
    Value* expected = e.read(first, type);
    Value* exchange =
        e.ir.CreateAtomicCmpXchg(pointer, expected, e.read(first + 1, type), align, order, order);
    return e.ir.CreateExtractValue(exchange, 0);
  }
  Value* value = e.read(first, type);
  if (operation == "inc" || operation == "dec") {
    if (type.bits != 32) e.refuse("u32");
    return e.call_host(operation == "inc" ? "warpgrain_atomic_inc" : "warpgrain_atomic_dec", e.type(type),
                       {pointer, value});
  }
  static const std::unordered_map<std::string_view, Rmw::BinOp> operations{
      {"exch", Rmw::Xchg}, {"and", Rmw::And}, {"or", Rmw::Or}, {"xor", Rmw::Xor}};
  Rmw::BinOp chosen{};
  if (const auto found = operations.find(operation); found != operations.end())
    chosen = found->second;
  else if (operation == "add")
    chosen = type.is_float() ? Rmw::FAdd : Rmw::Add;
  else if (operation == "min")
    chosen = type.is_signed() ? Rmw::Min : Rmw::UMin;
  else if (operation == "max")
    chosen = type.is_signed() ? Rmw::Max : Rmw::UMax;
  else
    e.refuse("an atomic operation");
  if (type.is_float() && (operation != "add" || type.bits == 16)) e.refuse("an integer type");
  return e.ir.CreateAtomicRMW(chosen, pointer, value, align, order);
}

// Every atomic is sequentially consistent, which is as strict as any order that it may ask for.
void emit_atomic(Emitter& e, bool returns_old) {
  ModifierReader& modifiers = e.modifiers();
  modifiers.take_one_of({"relaxed", "acquire", "release", "acq_rel"});
  modifiers.take_one_of({"cta", "gpu", "sys"});
  Access access;
  access.space = take_space(e);
  access.is_ordered = true;
  const std::string_view operation =
      modifiers.take_one_of({"add", "min", "max", "and", "or", "xor", "exch", "cas", "inc", "dec"});
  modifiers.drop_prefixed("L2::");
  const ScalarType type = e.take_type();
  const std::size_t address = returns_old ? 1 : 0;
  Value* pointer = e.pointer(e.operand(address));
  trace_if_listed(e, pointer);
  access.type = type;
  pointer = e.checked(pointer, e.operand(address), site_of(access, AccessKind::atomic));
  Value* old = atomic_operation(e, operation, pointer, type, address + 1);
  if (returns_old) e.write(old, type);
}

void emit_atom(Emitter& e) { emit_atomic(e, true); }
void emit_red(Emitter& e) { emit_atomic(e, false); }

void emit_fence(Emitter& e) {
  e.modifiers().take_one_of({"sc", "acq_rel"});
  e.modifiers().take_one_of({"cta", "gl", "gpu", "sys"});
  e.ir.CreateFence(llvm::AtomicOrdering::SequentiallyConsistent);
}

// A hint.
void emit_prefetch(Emitter& e) {
  e.modifiers().take_space();
  e.modifiers().take_one_of({"L1", "L2"});
}

}  // namespace

const InstructionTable& memory_instructions() {
  static const InstructionTable table{
      {"ld", emit_load},     {"ldu", emit_load},          {"st", emit_store},
      {"atom", emit_atom},   {"red", emit_red},           {"membar", emit_fence},
      {"fence", emit_fence}, {"prefetch", emit_prefetch}, {"prefetchu", emit_prefetch},
  };
  return table;
}

}  // namespace warpgrain::profiler::ptx
