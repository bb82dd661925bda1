// Moves, and addresses from space to space.

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

// mov.b64 %rd, {%r0, %r1}: the first element lies lowest.
Value* pack(Emitter& e, const Operand& vector, ScalarType type) {
  const auto width = static_cast<std::uint8_t>(type.bits / vector.elements.size());
  Value* packed = llvm::ConstantInt::get(e.int_type(type.bits), 0);
  for (std::size_t i = 0; i < vector.elements.size(); ++i) {
    Value* element = e.ir.CreateZExt(e.read(vector.elements[i], bits_type(width)), e.int_type(type.bits));
    packed = e.ir.CreateOr(packed, e.ir.CreateShl(element, i * width));
  }
  return packed;
}

void unpack(Emitter& e, const Operand& vector, Value* value, ScalarType type) {
  const auto width = static_cast<std::uint8_t>(type.bits / vector.elements.size());
  for (std::size_t i = 0; i < vector.elements.size(); ++i)
    e.write(vector.elements[i], e.ir.CreateTrunc(e.ir.CreateLShr(value, i * width), e.int_type(width)),
            bits_type(width));
}

void emit_mov(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::any);
  const Operand& to = e.operand(0);
  const Operand& from = e.operand(1);
  const bool packs = from.kind == Operand::Kind::vector;
  const bool unpacks = to.kind == Operand::Kind::vector;
  if (packs && unpacks) e.refuse("a register on one side");
  const std::size_t elements = packs ? from.elements.size() : unpacks ? to.elements.size() : 1;
  if (elements == 0 || type.bits % (8 * elements) != 0) {
    if (packs || unpacks) e.refuse("2 or 4 elements");
  }
  if (packs) return e.write(pack(e, from, type), bits_type(type.bits));
  if (unpacks) return unpack(e, to, e.read(from, bits_type(type.bits)), type);
  e.write(e.read(from, type), type);
}

// Every address is a host address, whatever its space.
void emit_cvta(Emitter& e) {
  e.modifiers().take("to");
  e.modifiers().take_space();
  const ScalarType type = e.take_type(Emitter::Types::integer);
  e.write(e.read(1, type), type);
}

}  // namespace

const InstructionTable& move_instructions() {
  static const InstructionTable table{{"mov", emit_mov}, {"cvta", emit_cvta}};
  return table;
}

}  // namespace warpgrain::profiler::ptx
