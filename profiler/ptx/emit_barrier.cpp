// Barriers of the work-group, numbered and counted, and of the warp.

#include "profiler/ptx/instructions.hpp"
#include "profiler/ptx/rendezvous_emitter.hpp"

namespace warpgrain::profiler::ptx {
namespace {

const ScalarType u32{ScalarType::Kind::unsigned_integer, 32};

// bar.warp.sync mask
void emit_warp_barrier(Emitter& e) {
  if (!e.modifiers().take("sync")) e.refuse(".sync");
  emit_rendezvous(e, Meeting::warp_barrier, {.members = e.read(0, u32)});
}

// The number behind any result, the thread count, and the predicate of a reduction.
RendezvousFields read_barrier(Emitter& e, std::size_t first, bool reduces) {
  RendezvousFields fields;
  fields.index = e.read(first, u32);
  const std::size_t last = e.operand_count() - (reduces ? 1 : 0);
  if (last > first + 1) fields.bound = e.read(first + 1, u32);
  if (reduces) fields.value = e.read(e.operand_count() - 1, predicate_type);
  return fields;
}

// bar.red.popc.u32 d, a, {b,} p;  bar.red.and.pred q, a, {b,} p
void emit_reduction(Emitter& e, bool aligned) {
  const std::string_view operation = e.modifiers().take_one_of({"popc", "and", "or"});
  if (operation.empty()) e.refuse(".popc, .and or .or");
  const ScalarType type = e.take_type(operation == "popc" ? Emitter::Types::integer : Emitter::Types::any);
  RendezvousFields fields = read_barrier(e, 1, true);
  fields.aligned = aligned;
  if (operation == "popc") {
    emit_rendezvous(e, Meeting::barrier_popc, fields);
    return e.write(rendezvous_result(e, e.int_type(32)), u32);
  }
  if (!type.is_predicate()) e.refuse(".pred");
  emit_rendezvous(e, operation == "and" ? Meeting::barrier_and : Meeting::barrier_or, fields);
  e.write(rendezvous_holds(e), predicate_type);
}

void emit_barrier(Emitter& e) {
  if (e.modifiers().take("warp")) return emit_warp_barrier(e);
  e.modifiers().take("cta");
  const std::string_view kind = e.modifiers().take_one_of({"sync", "arrive", "red"});
  const bool aligned = e.modifiers().take("aligned") || e.statement().opcode == "bar";
  if (kind == "red") return emit_reduction(e, aligned);
  RendezvousFields fields = read_barrier(e, 0, false);
  fields.aligned = aligned;
  if (kind == "arrive") {
    if (fields.bound == nullptr) e.refuse("a thread count");
    return emit_rendezvous(e, Meeting::barrier_arrive, fields);
  }
  if (kind != "sync") e.refuse("bar.sync, bar.arrive, bar.red or bar.warp.sync");
  emit_rendezvous(e, Meeting::barrier, fields);
}

}  // namespace

const InstructionTable& barrier_instructions() {
  static const InstructionTable table{{"bar", emit_barrier}, {"barrier", emit_barrier}};
  return table;
}

}  // namespace warpgrain::profiler::ptx
