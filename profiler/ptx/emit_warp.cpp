// Operations between the lanes of a warp. Forms without `.sync` name no members: the lanes that are there
// take part.

#include "profiler/ptx/instructions.hpp"
#include "profiler/ptx/rendezvous_emitter.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

const ScalarType u32{ScalarType::Kind::unsigned_integer, 32};

// The member mask, which is the operand at `index` of a `.sync` form.
Value* members(Emitter& e, bool sync, std::size_t index) { return sync ? e.read(index, u32) : nullptr; }

// d|p, or d alone.
void write_with_predicate(Emitter& e, Value* value, ScalarType type) {
  const Operand& target = e.operand(0);
  if (target.kind != Operand::Kind::pair) return e.write(value, type);
  Value* holds = rendezvous_holds(e);
  e.write(target.elements[0], value, type);
  e.write(target.elements[1], holds, predicate_type);
}

// shfl.sync.mode.b32 d|p, a, b, c, membermask
void emit_shfl(Emitter& e) {
  const bool sync = e.modifiers().take("sync");
  const std::string_view mode = e.modifiers().take_one_of({"up", "down", "bfly", "idx"});
  const ScalarType type = e.take_type();
  if (mode.empty() || type.bits != 32) e.refuse(".up, .down, .bfly or .idx of b32");
  const Meeting meeting = mode == "up"     ? Meeting::shuffle_up
                          : mode == "down" ? Meeting::shuffle_down
                          : mode == "bfly" ? Meeting::shuffle_butterfly
                                           : Meeting::shuffle_index;
  emit_rendezvous(e, meeting,
                  {.members = members(e, sync, 4),
                   .index = e.read(2, u32),
                   .bound = e.read(3, u32),
                   .value = e.read(1, bits_type(32))});
  write_with_predicate(e, rendezvous_result(e, e.int_type(32)), bits_type(32));
}

// vote.sync.mode.pred p, a, membermask;  vote.sync.ballot.b32 d, a, membermask
void emit_vote(Emitter& e) {
  const bool sync = e.modifiers().take("sync");
  const std::string_view mode = e.modifiers().take_one_of({"all", "any", "uni", "ballot"});
  const ScalarType type = e.take_type(Emitter::Types::integer_or_predicate);
  const bool is_ballot = mode == "ballot";
  if (mode.empty() || type.is_predicate() == is_ballot)
    e.refuse(".all, .any or .uni of pred, or .ballot of b32");
  const Meeting meeting = mode == "all"   ? Meeting::vote_all
                          : mode == "any" ? Meeting::vote_any
                          : mode == "uni" ? Meeting::vote_uniform
                                          : Meeting::vote_ballot;
  emit_rendezvous(e, meeting, {.members = members(e, sync, 2), .value = e.read(1, predicate_type)});
  if (is_ballot) return e.write(rendezvous_result(e, e.int_type(32)), u32);
  e.write(rendezvous_holds(e), predicate_type);
}

// match.any.sync.b64 d, a, membermask;  match.all.sync.b64 d|p, a, membermask
void emit_match(Emitter& e) {
  const std::string_view mode = e.modifiers().take_one_of({"any", "all"});
  const bool sync = e.modifiers().take("sync");
  const ScalarType type = e.take_type(Emitter::Types::integer);
  if (mode.empty() || !sync || type.bits < 32) e.refuse(".any or .all, with .sync, of b32 or b64");
  emit_rendezvous(e, mode == "any" ? Meeting::match_any : Meeting::match_all,
                  {.members = members(e, sync, 2), .value = e.read(1, type)});
  write_with_predicate(e, rendezvous_result(e, e.int_type(32)), u32);
}

void emit_activemask(Emitter& e) {
  e.take_type(Emitter::Types::integer);
  emit_rendezvous(e, Meeting::active_mask, {});
  e.write(rendezvous_result(e, e.int_type(32)), u32);
}

// elect.sync d|p, membermask: the lowest lane there is.
void emit_elect(Emitter& e) {
  if (!e.modifiers().take("sync")) e.refuse(".sync");
  emit_rendezvous(e, Meeting::elect, {.members = e.read(1, u32)});
  write_with_predicate(e, rendezvous_result(e, e.int_type(32)), u32);
}

// redux.sync.op.type d, a, membermask
void emit_redux(Emitter& e) {
  const bool sync = e.modifiers().take("sync");
  const std::string_view operation = e.modifiers().take_one_of({"add", "min", "max", "and", "or", "xor"});
  const ScalarType type = e.take_type(Emitter::Types::integer);
  if (!sync || operation.empty() || type.bits != 32) e.refuse(".sync and an operation of 32-bit integers");
  const bool is_signed = type.is_signed();
  const Meeting meeting =
      operation == "add"   ? Meeting::reduce_add
      : operation == "min" ? is_signed ? Meeting::reduce_min_signed : Meeting::reduce_min_unsigned
      : operation == "max" ? is_signed ? Meeting::reduce_max_signed : Meeting::reduce_max_unsigned
      : operation == "and" ? Meeting::reduce_and
      : operation == "or"  ? Meeting::reduce_or
                           : Meeting::reduce_xor;
  emit_rendezvous(e, meeting, {.members = members(e, sync, 2), .value = e.read(1, type)});
  e.write(rendezvous_result(e, e.int_type(32)), type);
}

}  // namespace

const InstructionTable& warp_instructions() {
  static const InstructionTable table{
      {"shfl", emit_shfl},   {"vote", emit_vote},   {"match", emit_match}, {"activemask", emit_activemask},
      {"elect", emit_elect}, {"redux", emit_redux},
  };
  return table;
}

}  // namespace warpgrain::profiler::ptx
