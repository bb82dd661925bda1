#include "profiler/sass/decoder.hpp"

#include <cstring>

#include "profiler/sass/opcodes.hpp"

namespace warpgrain::profiler::sass {
namespace {

constexpr std::uint16_t load_constant = 0xB82;  // LDC

struct Word {
  std::uint64_t low, high;

  std::uint64_t bits(unsigned first, unsigned last) const {  // inclusive; not across the middle
    const std::uint64_t half = first < 64 ? low >> first : high >> (first - 64);
    return half & ((std::uint64_t{1} << (last - first + 1)) - 1);
  }
};

std::int64_t sign_extended(std::uint64_t value, unsigned n_bits) {
  const unsigned shift = 64 - n_bits;
  return static_cast<std::int64_t>(value << shift) >> shift;
}

// Branches and calls, in units of four bytes: 48 bits from bit 34 on, and from sm_90 on eight more below them
// in bits 16 to 23.
std::uint32_t branch_target(const Word& word, std::uint32_t address, unsigned sm) {
  const std::uint64_t upper = word.bits(34, 63) | word.bits(64, 81) << 30;
  const std::int64_t offset =
      sm >= 90 ? sign_extended(upper << 8 | word.bits(16, 23), 56) : sign_extended(upper, 48);
  return static_cast<std::uint32_t>(address + instruction_bytes + offset * 4);
}

// BSSY: 30 bits in units of four bytes.
std::uint32_t meeting_target(const Word& word, std::uint32_t address) {
  return static_cast<std::uint32_t>(address + instruction_bytes + sign_extended(word.bits(34, 63), 30) * 4);
}

constexpr std::uint16_t operation_number(std::uint16_t opcode) { return opcode & 0x1FFU; }

void decode_branch_conditions(const Word& word, Instruction& instruction) {
  instruction.condition = static_cast<std::uint8_t>(word.bits(87, 89));
  instruction.condition_negated = word.bits(90, 90) != 0;
  if ((instruction.opcode & 0x1FFFU) == 0x1547) {  // BRA of a uniform predicate
    instruction.condition = static_cast<std::uint8_t>(word.bits(24, 26));
    instruction.condition_negated = word.bits(27, 27) != 0;
    instruction.uniform_condition = true;
  }
  instruction.if_divergent = word.bits(32, 33) == 2;
}

void decode_flow(const Word& word, unsigned sm, Instruction& i) {
  i.barrier = static_cast<std::uint8_t>(word.bits(16, 19));
  switch (operation_number(i.opcode)) {
    case 0x141:
      i.flow = Flow::meet;
      break;
    case 0x142:
      i.flow = Flow::leave;
      break;
    case 0x143:
      i.flow = Flow::indirect_call;
      break;
    case 0x144:
      i.flow = Flow::call;
      i.target = branch_target(word, i.address, sm);
      break;
    case 0x145:
      i.flow = Flow::open;
      i.target = meeting_target(word, i.address);
      break;
    case 0x146:
      i.flow = Flow::yield;
      break;
    case 0x147:
      i.flow = Flow::branch;
      i.target = branch_target(word, i.address, sm);
      decode_branch_conditions(word, i);
      break;
    case 0x148:
      i.flow = Flow::warp_meet;
      break;
    case 0x149:
    case 0x14A:
    case 0x14C:
    case 0x158:
    case 0x159:
      i.flow = Flow::indirect_branch;
      break;
    case 0x14D:
    case 0x15B:
      i.flow = Flow::exit;
      break;
    case 0x150:
      i.flow = Flow::ret;
      break;
    case 0x155:                          // BMOV R, B
      if (word.bits(9, 11) == 7) break;  // BMOV B, B: sm_87 clears all barriers at its begin
      i.flow = Flow::save;
      i.barrier = static_cast<std::uint8_t>(word.bits(24, 27));
      i.reg = static_cast<std::uint8_t>(word.bits(16, 23));
      break;
    case 0x156:  // BMOV B, R
      i.flow = Flow::restore;
      i.barrier = static_cast<std::uint8_t>(word.bits(24, 27));
      i.reg = static_cast<std::uint8_t>(word.bits(32, 39));
      break;
    default:
      break;
  }
}

// Which fields hold predicates that the operation writes.
unsigned predicate_destinations(std::uint16_t number) {
  switch (number) {
    case 0x00B:  // FSETP
    case 0x00C:  // ISETP
    case 0x010:  // IADD3, its carries
    case 0x01C:  // PLOP3
    case 0x02A:  // DSETP
    case 0x034:  // HSETP2
      return 2;
    case 0x006:  // VOTE
    case 0x011:  // LEA
    case 0x012:  // LOP3
    case 0x025:  // IMAD.WIDE
    case 0x027:  // IMAD.HI
    case 0x102:  // FCHK
    case 0x189:  // SHFL
    case 0x18A:  // atomic operations that say whether they succeeded
    case 0x18B:
    case 0x18D:
    case 0x195:  // QSPC
    case 0x1A1:  // MATCH
    case 0x1A8:
    case 0x1A9:
      return 1;
    default:
      return 0;
  }
}

void decode_predicates(const Word& word, Instruction& i) {
  const std::uint16_t number = operation_number(i.opcode);
  const auto write = [&](std::uint64_t predicate) {
    if (predicate != always) i.predicates_written |= static_cast<std::uint8_t>(1U << predicate);
  };
  const unsigned n = predicate_destinations(number);
  if (n > 0) write(word.bits(81, 83));
  if (n > 1) write(word.bits(84, 86));
  if (number == 0x004) i.predicates_written = 0x7F;  // R2P
  const bool no_inputs =
      word.bits(68, 70) == always && word.bits(77, 79) == always && word.bits(87, 89) == always;
  const bool negated = word.bits(71, 71) != 0 || word.bits(80, 80) != 0 || word.bits(90, 90) != 0;
  if (number == 0x01C && no_inputs && !negated && word.bits(84, 86) == always)
    i.constant_predicate = static_cast<std::int8_t>(word.bits(76, 76));  // of its table, all inputs true
}

bool is_padding(const Instruction& instruction) {
  return operation_number(instruction.opcode) == 0x118 ||
         (instruction.flow == Flow::branch && instruction.target == instruction.address);
}

}  // namespace

std::vector<Instruction> decode(std::string_view code, unsigned sm) {
  std::vector<Instruction> instructions;
  for (std::size_t at = 0; at + instruction_bytes <= code.size(); at += instruction_bytes) {
    Word word{};
    std::memcpy(&word.low, code.data() + at, sizeof word.low);
    std::memcpy(&word.high, code.data() + at + sizeof word.low, sizeof word.high);
    Instruction instruction;
    instruction.address = static_cast<std::uint32_t>(at);
    instruction.opcode = static_cast<std::uint16_t>(word.bits(0, 11) | word.bits(91, 91) << 12);
    instruction.guard = static_cast<std::uint8_t>(word.bits(12, 14));
    instruction.guard_negated = word.bits(15, 15) != 0;
    instruction.destination = static_cast<std::uint8_t>(word.bits(16, 23));
    instruction.source = static_cast<std::uint8_t>(word.bits(24, 31));
    instruction.has_immediate = (instruction.opcode >> 9 & 7U) == 4;
    instruction.immediate = static_cast<std::int32_t>(word.bits(32, 63));
    if (instruction.opcode == load_constant) {
      instruction.constant_offset = static_cast<std::uint32_t>(word.bits(38, 53));
      instruction.constant_bank = static_cast<std::uint8_t>(word.bits(54, 58));
    }
    if (const Operation* operation = find_operation(operation_number(instruction.opcode))) {
      instruction.instruction_class = operation->instruction_class;
      instruction.special_function = operation->special_function;
    }
    decode_flow(word, sm, instruction);
    decode_predicates(word, instruction);
    instructions.push_back(instruction);
  }
  while (!instructions.empty() && is_padding(instructions.back())) instructions.pop_back();
  return instructions;
}

std::string_view mnemonic(const Instruction& instruction) {
  const Operation* operation = find_operation(operation_number(instruction.opcode));
  return operation == nullptr ? "?" : operation->name;
}

}  // namespace warpgrain::profiler::sass
