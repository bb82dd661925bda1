#include "tests/profiler/oracle/work_group.hpp"

#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>

namespace warpgrain::oracle {
namespace {

Bits cut_to(ptx::ScalarType type, Bits value) {
  return type.bits == 64 ? value : value & ((Bits{1} << type.bits) - 1);
}

// A lane's local memory begins at a multiple of what any variable is aligned to.
std::uint32_t local_stride(const Program& program) { return (program.local_bytes + 255) / 256 * 256; }

}  // namespace

WorkGroup::WorkGroup(const Program& program, Memory& memory, const profiler::LaunchShape& shape,
                     const std::array<std::uint64_t, 3>& group)
    : program_(program),
      memory_(memory),
      special_(shape.work_group_size()),
      registers_(shape.work_group_size() * std::size_t{program.n_registers}),
      local_(shape.work_group_size() * std::size_t{local_stride(program)}) {
  memory_.set(Memory::local, local_);
  const auto groups = shape.group_count();
  for (std::uint32_t lane = 0; lane < size(); ++lane) {
    auto& special = special_[lane];
    std::uint32_t rest = lane;
    for (std::size_t d = 0; d < 3; ++d) {
      const std::string axis(1, "xyz"[d]);
      special["%tid." + axis] = rest % shape.local_size[d];
      rest /= shape.local_size[d];
      special["%ntid." + axis] = shape.local_size[d];
      special["%ctaid." + axis] = static_cast<std::uint32_t>(group[d]);
      special["%nctaid." + axis] = static_cast<std::uint32_t>(groups[d]);
    }
    for (int i = 0; i < 32; ++i) special[fmt::format("%envreg{}", i)] = 0;  // launches have no offset
  }
}

Bits WorkGroup::read(const Source& source, ptx::ScalarType type, std::uint32_t lane) const {
  switch (source.kind) {
    case Source::Kind::reg: {
      const Bits value = registers_[std::size_t{lane} * program_.n_registers + source.index] + source.value;
      return cut_to(type, source.negated ? value ^ 1 : value);
    }
    case Source::Kind::bits:
      return type.is_predicate() ? Bits{source.value != 0} : cut_to(type, source.value);
    case Source::Kind::float32:
      if (type.is_float() && type.bits == 64)
        return bits_of<double>(std::bit_cast<float>(static_cast<std::uint32_t>(source.value)));
      return source.value;
    case Source::Kind::float64:
      if (type.is_float() && type.bits == 32)
        return bits_of(static_cast<float>(std::bit_cast<double>(source.value)));
      return source.value;
    case Source::Kind::special: {
      const auto found = special_[lane].find(source.special);
      if (found == special_[lane].end()) throw UnknownInstruction(fmt::format("'{}'", source.special));
      return cut_to(type, found->second);
    }
    case Source::Kind::address:
      return cut_to(type, source.value);
    case Source::Kind::lane_address:
      return cut_to(
          type, Memory::base_of(Memory::local) + std::size_t{lane} * local_stride(program_) + source.value);
    case Source::Kind::nothing:
      break;
  }
  throw std::logic_error("an operand that cannot be read");
}

void WorkGroup::write(const Source& target, Bits value, std::uint32_t lane) {
  if (target.kind == Source::Kind::nothing) return;
  if (target.kind != Source::Kind::reg) throw std::logic_error("an operand that cannot be written");
  registers_[std::size_t{lane} * program_.n_registers + target.index] = cut_to(target.type, value);
}

bool WorkGroup::takes_part(const Step& step, std::uint32_t lane) const {
  return !step.guard || read(*step.guard, ptx::predicate_type, lane) != 0;
}

void WorkGroup::execute(const Step& step, std::uint32_t lane) {
  switch (step.kind) {
    case Step::Kind::compute:
      return compute(step, lane);
    case Step::Kind::pack: {
      Bits packed = 0;
      for (std::size_t i = 0; i < step.inputs.size(); ++i)
        packed |= read(step.inputs[i], step.element, lane) << (i * step.element.bits);
      return write(step.outputs[0], packed, lane);
    }
    case Step::Kind::unpack: {
      const auto width = static_cast<std::uint8_t>(step.element.bits * step.outputs.size());
      const Bits packed = read(step.inputs[0], ptx::bits_type(width), lane);
      for (std::size_t i = 0; i < step.outputs.size(); ++i)
        write(step.outputs[i], cut_to(step.element, packed >> (i * step.element.bits)), lane);
      return;
    }
    case Step::Kind::load:
      return load(step, lane);
    case Step::Kind::store:
      return store(step, lane);
    case Step::Kind::atomic:
      return atomic(step, lane);
    case Step::Kind::trap:
      throw std::runtime_error(fmt::format("a lane ran '{}'", step.statement->text));
    case Step::Kind::barrier:
    case Step::Kind::jump:
    case Step::Kind::nothing:
      return;
  }
}

void WorkGroup::compute(const Step& step, std::uint32_t lane) {
  std::array<Bits, 4> inputs{};
  for (std::size_t i = 0; i < step.inputs.size(); ++i)
    inputs[i] = read(step.inputs[i], step.operation.inputs[i], lane);
  write(step.outputs[0], step.operation.compute(inputs.data()), lane);
}

void WorkGroup::load(const Step& step, std::uint32_t lane) {
  const std::uint32_t bytes = step.element.bytes();
  const std::byte* const from =
      memory_.at(address(step, lane), bytes * static_cast<std::uint32_t>(step.outputs.size()));
  for (std::size_t i = 0; i < step.outputs.size(); ++i) {
    Bits value = 0;
    std::memcpy(&value, from + i * bytes, bytes);
    // Into a wider register a signed value goes with its sign.
    if (step.element.is_signed() && step.element.bits < 64) {
      const Bits sign = Bits{1} << (step.element.bits - 1);
      value = (value ^ sign) - sign;
    }
    write(step.outputs[i], value, lane);
  }
}

void WorkGroup::store(const Step& step, std::uint32_t lane) {
  const std::uint32_t bytes = step.element.bytes();
  std::byte* const to =
      memory_.at(address(step, lane), bytes * static_cast<std::uint32_t>(step.inputs.size()));
  for (std::size_t i = 0; i < step.inputs.size(); ++i) {
    const Bits value = read(step.inputs[i], step.element, lane);
    std::memcpy(to + i * bytes, &value, bytes);
  }
}

void WorkGroup::atomic(const Step& step, std::uint32_t lane) {
  const std::uint32_t bytes = step.element.bytes();
  std::byte* const at = memory_.at(address(step, lane), bytes);
  std::array<Bits, 3> inputs{};
  std::memcpy(inputs.data(), at, bytes);
  for (std::size_t i = 0; i < step.inputs.size(); ++i)
    inputs[i + 1] = read(step.inputs[i], step.element, lane);
  const Bits changed = step.operation.compute(inputs.data());
  std::memcpy(at, &changed, bytes);
  if (!step.outputs.empty()) write(step.outputs[0], inputs[0], lane);
}

Place WorkGroup::next(const Step& step, std::uint32_t lane) const {
  if (!step.table.empty()) {
    const Bits index = read(step.inputs[0], ptx::bits_type(32), lane);
    if (index >= step.table.size()) throw std::runtime_error("a branch beyond its table");
    return step.table[index];
  }
  return takes_part(step, lane) ? step.to.front() : step.to.back();
}

}  // namespace warpgrain::oracle
