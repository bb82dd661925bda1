#pragma once
// What a cubin (an ELF file) holds of one kernel: its machine code, the line of each instruction, and the
// words of its constant bank that indirect branches read their targets from.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::profiler::sass {

struct LineRow {
  std::uint32_t address = 0;  // in the kernel's code; the line holds up to the next row
  std::uint32_t line = 0;
};

struct KernelCode {
  std::string text;                         // 16 bytes an instruction
  std::vector<LineRow> lines;               // by address; empty without a line table
  std::uint32_t registers = 0;              // of a lane; 0 where the file does not say
  std::vector<std::uint32_t> branch_table;  // of the constant bank 2
};

// Throws InputError for what is no such file or has no such kernel.
KernelCode read_kernel_code(std::string_view cubin, std::string_view entry);

}  // namespace warpgrain::profiler::sass
