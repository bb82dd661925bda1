#include "profiler/sass/line_program.hpp"

#include <cstring>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::profiler::sass {
namespace {

class Reader {
 public:
  Reader(std::string_view bytes, std::uint64_t at, std::uint64_t end) : bytes_(bytes), at_(at), end_(end) {}
  std::uint64_t at() const { return at_; }
  bool at_end() const { return at_ >= end_; }
  void go_to(std::uint64_t at) { at_ = at; }

  template <class T>
  T read() {
    if (end_ > bytes_.size() || at_ > end_ || end_ - at_ < sizeof(T))
      throw_input_error("cubin, .debug_line", fmt::format("an end at byte {}", at_), "a complete section");
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::uint64_t unsigned_leb() {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const auto byte = read<std::uint8_t>();
      if (shift < 64) value |= std::uint64_t{byte & 0x7FU} << shift;
      if ((byte & 0x80U) == 0) return value;
    }
  }
  std::int64_t signed_leb() {
    std::int64_t value = 0;
    unsigned shift = 0;
    std::uint8_t byte = 0;
    do {
      byte = read<std::uint8_t>();
      if (shift < 64) value |= static_cast<std::int64_t>(byte & 0x7FU) << shift;
      shift += 7;
    } while ((byte & 0x80U) != 0);
    if (shift < 64 && (byte & 0x40U) != 0) value |= -(std::int64_t{1} << shift);
    return value;
  }

 private:
  std::string_view bytes_;
  std::uint64_t at_, end_;
};

// The state machine of one unit.
class LineMachine {
 public:
  explicit LineMachine(std::vector<LineSequence>& sequences) : sequences_(sequences) {}

  void run(Reader& reader) {
    read_header(reader);
    while (!reader.at_end()) step(reader);
  }

 private:
  void read_header(Reader& reader) {
    const auto version = reader.read<std::uint16_t>();
    if (version < 2 || version > 4)
      throw_input_error("cubin, .debug_line", fmt::format("version {}", version), "2 to 4");
    const auto header_length = reader.read<std::uint32_t>();
    const std::uint64_t program = reader.at() + header_length;
    minimum_length_ = reader.read<std::uint8_t>();
    if (version == 4) reader.read<std::uint8_t>();  // operations an instruction
    reader.read<std::uint8_t>();                    // default_is_stmt
    line_base_ = reader.read<std::int8_t>();
    line_range_ = reader.read<std::uint8_t>();
    opcode_base_ = reader.read<std::uint8_t>();
    if (line_range_ == 0 || opcode_base_ == 0)
      throw_input_error("cubin, .debug_line", "a line range of 0", "a header of DWARF 2");
    for (unsigned k = 1; k < opcode_base_; ++k) lengths_.push_back(reader.read<std::uint8_t>());
    reader.go_to(program);
  }

  void step(Reader& reader) {
    const auto opcode = reader.read<std::uint8_t>();
    if (opcode >= opcode_base_) {
      const unsigned adjusted = opcode - opcode_base_;
      address_ += std::uint64_t{minimum_length_} * (adjusted / line_range_);
      line_ += line_base_ + static_cast<std::int64_t>(adjusted % line_range_);
      add_row();
      return;
    }
    switch (opcode) {
      case 0:
        extended(reader);
        break;
      case 1:  // copy
        add_row();
        break;
      case 2:  // advance_pc
        address_ += minimum_length_ * reader.unsigned_leb();
        break;
      case 3:  // advance_line
        line_ += reader.signed_leb();
        break;
      case 8:  // const_add_pc
        address_ += std::uint64_t{minimum_length_} * ((255U - opcode_base_) / line_range_);
        break;
      case 9:  // fixed_advance_pc
        address_ += reader.read<std::uint16_t>();
        break;
      default:
        for (unsigned k = 0; k < lengths_[opcode - 1U]; ++k) reader.unsigned_leb();
    }
  }

  void extended(Reader& reader) {
    const std::uint64_t length = reader.unsigned_leb();
    const std::uint64_t next = reader.at() + length;
    if (length == 0) return;
    switch (reader.read<std::uint8_t>()) {
      case 1:  // end_sequence
        open_ = false;
        line_ = 1;
        break;
      case 2:  // set_address
        sequences_.push_back({reader.at(), {}});
        address_ = reader.read<std::uint64_t>();
        open_ = true;
        break;
      default:
        break;
    }
    reader.go_to(next);
  }

  void add_row() {
    if (open_)
      sequences_.back().rows.push_back(
          {static_cast<std::uint32_t>(address_), static_cast<std::uint32_t>(line_)});
  }

  std::vector<LineSequence>& sequences_;
  unsigned minimum_length_ = 1, line_range_ = 1, opcode_base_ = 1;
  std::int64_t line_base_ = 0;
  std::vector<std::uint8_t> lengths_;  // operands of each standard opcode
  std::uint64_t address_ = 0;
  std::int64_t line_ = 1;
  bool open_ = false;
};

}  // namespace

std::vector<LineSequence> read_line_program(std::string_view section) {
  std::vector<LineSequence> sequences;
  for (std::uint64_t at = 0; at < section.size();) {
    Reader length(section, at, section.size());
    const std::uint64_t end = at + 4 + length.read<std::uint32_t>();
    Reader unit(section, at + 4, end);
    LineMachine(sequences).run(unit);
    at = end;
  }
  return sequences;
}

}  // namespace warpgrain::profiler::sass
