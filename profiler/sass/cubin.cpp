#include "profiler/sass/cubin.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <map>

#include "core/error.hpp"
#include "profiler/sass/line_program.hpp"

namespace warpgrain::profiler::sass {
namespace {

template <class T>
T read_at(std::string_view bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T))
    throw_input_error("cubin", fmt::format("{} bytes at {}", bytes.size(), offset), "a complete ELF file");
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

std::string_view text_at(std::string_view bytes, std::uint64_t offset) {
  if (offset >= bytes.size()) return {};
  const std::string_view rest = bytes.substr(offset);
  return rest.substr(0, rest.find('\0'));
}

// ELF64, little-endian: "Executable and Linking Format", the structures Elf64_Ehdr, Elf64_Shdr, Elf64_Sym and
// Elf64_Rela.
class ElfFile {
 public:
  struct Section {
    std::string_view name, bytes;
  };

  explicit ElfFile(std::string_view file) {
    if (!file.starts_with("\177ELF\2\1"))
      throw_input_error("cubin", "no ELF file of 64 bits", "what ptxas writes");
    const auto table = read_at<std::uint64_t>(file, 0x28);
    const auto count = read_at<std::uint16_t>(file, 0x3C), names = read_at<std::uint16_t>(file, 0x3E);
    constexpr std::uint32_t no_bytes = 8;  // SHT_NOBITS
    std::vector<std::uint32_t> name_offsets;
    for (std::uint16_t i = 0; i < count; ++i) {
      const std::uint64_t header = table + std::uint64_t{i} * 64;
      name_offsets.push_back(read_at<std::uint32_t>(file, header));
      const auto offset = read_at<std::uint64_t>(file, header + 24),
                 size = read_at<std::uint64_t>(file, header + 32);
      const bool empty = read_at<std::uint32_t>(file, header + 4) == no_bytes || offset > file.size();
      sections_.push_back({{}, empty ? std::string_view{} : file.substr(offset, size)});
    }
    if (names >= count) throw_input_error("cubin", "no section names", "what ptxas writes");
    for (std::uint16_t i = 0; i < count; ++i)
      sections_[i].name = text_at(sections_[names].bytes, name_offsets[i]);
  }

  std::string_view section(std::string_view name) const {
    for (const Section& s : sections_)
      if (s.name == name) return s.bytes;
    return {};
  }

  // Of a section: the name of the section that each relocated place points into.
  std::map<std::uint64_t, std::string_view> relocations(std::string_view of) const {
    const std::string_view symbols = section(".symtab");
    std::map<std::uint64_t, std::string_view> result;
    const auto note = [&](std::uint64_t place, std::uint64_t info) {
      const auto in = read_at<std::uint16_t>(symbols, (info >> 32) * 24 + 6);
      if (in < sections_.size()) result[place] = sections_[in].name;
    };
    const std::string_view with_addends = section(fmt::format(".rela{}", of));
    for (std::uint64_t at = 0; at + 24 <= with_addends.size(); at += 24)
      note(read_at<std::uint64_t>(with_addends, at), read_at<std::uint64_t>(with_addends, at + 8));
    const std::string_view without = section(fmt::format(".rel{}", of));
    for (std::uint64_t at = 0; at + 16 <= without.size(); at += 16)
      note(read_at<std::uint64_t>(without, at), read_at<std::uint64_t>(without, at + 8));
    return result;
  }

 private:
  std::vector<Section> sections_;
};

// The attribute of the section ".nv.info" that says how many registers the function of a symbol needs: a byte
// for the form (a value of so many bytes), one for the attribute, two for the size, then symbol and count.
// Seen in what ptxas writes; it prints the same number with -v.
constexpr std::uint8_t sized_value = 4, register_count = 0x2F;

std::uint32_t registers_of(const ElfFile& elf, std::string_view entry) {
  const std::string_view info = elf.section(".nv.info"), symbols = elf.section(".symtab"),
                         names = elf.section(".strtab");
  for (std::uint64_t at = 0; at + 4 <= info.size();) {
    const auto form = read_at<std::uint8_t>(info, at), attribute = read_at<std::uint8_t>(info, at + 1);
    const std::uint64_t size = form == sized_value ? read_at<std::uint16_t>(info, at + 2) : 0;
    if (form == sized_value && attribute == register_count) {
      const std::uint64_t symbol = read_at<std::uint32_t>(info, at + 4);
      if (text_at(names, read_at<std::uint32_t>(symbols, symbol * 24)) == entry)
        return read_at<std::uint32_t>(info, at + 8);
    }
    at += 4 + size;
  }
  return 0;
}

}  // namespace

KernelCode read_kernel_code(std::string_view cubin, std::string_view entry) {
  const ElfFile elf(cubin);
  const std::string section = fmt::format(".text.{}", entry);
  KernelCode code;
  code.text = elf.section(section);
  if (code.text.empty() || code.text.size() % 16 != 0)
    throw_input_error("cubin", fmt::format("no code of '{}'", entry), "a kernel of the module");
  code.registers = registers_of(elf, entry);
  const std::string_view table = elf.section(fmt::format(".nv.constant2.{}", entry));
  for (std::size_t at = 0; at + 4 <= table.size(); at += 4)
    code.branch_table.push_back(read_at<std::uint32_t>(table, at));
  const std::string_view program = elf.section(".debug_line");
  if (!program.empty()) {
    const auto relocations = elf.relocations(".debug_line");
    for (const LineSequence& sequence : read_line_program(program)) {
      const auto found = relocations.find(sequence.address_at);
      if (found == relocations.end() || found->second != section) continue;
      for (const LineRow& row : sequence.rows) code.lines.push_back(row);
    }
    std::stable_sort(code.lines.begin(), code.lines.end(),
                     [](const LineRow& a, const LineRow& b) { return a.address < b.address; });
  }
  return code;
}

}  // namespace warpgrain::profiler::sass
