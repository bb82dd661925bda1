#pragma once
// Reads listings as `nvdisasm -hex` and `cuobjdump -sass` print them: address, text and the two halves of
// each instruction.

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace warpgrain::profiler::sass {

struct ListedInstruction {
  std::uint32_t address = 0;
  std::string guard;     // "@!P0", or empty
  std::string mnemonic;  // "BRA.DIV"
  std::string operands;  // " UR4, 0x120"
  std::uint64_t low = 0, high = 0;
};

struct ListedKernel {
  std::string name;
  std::vector<ListedInstruction> instructions;
  std::map<std::string, std::uint32_t> labels;  // ".L_x_0" -> address

  std::string code() const {
    std::string bytes;
    for (const ListedInstruction& i : instructions)
      for (const std::uint64_t half : {i.low, i.high}) {
        char of_half[sizeof half];
        std::memcpy(of_half, &half, sizeof half);
        bytes.append(of_half, sizeof half);
      }
    return bytes;
  }
};

struct Listing {
  unsigned sm = 0;
  std::vector<ListedKernel> kernels;
};

// The architecture is the first "sm_NN" or "SMNN" of the file. A kernel begins where the address is 0.
inline Listing read_listing(const std::filesystem::path& path) {
  static const std::regex arch("[sS][mM]_?([0-9]+)"), label(R"(^\s*([.$][A-Za-z0-9_.$]+):)"),
      name(R"((?:kernel|Function :|\.text\.)\s*([A-Za-z_][A-Za-z0-9_$]*))"),
      first(
          R"(/\*([0-9a-f]{4,})\*/\s+\{?\s*(@!?U?P[0-9T]\s+)?([A-Z][A-Z0-9_.a-z]*)\s*([^;]*);.*/\* 0x([0-9a-f]{16}) \*/)"),
      second(R"(^\s*/\* 0x([0-9a-f]{16}) \*/)");
  Listing listing;
  std::ifstream in(path);
  std::vector<std::string> pending_labels;
  std::string pending_name;
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (listing.sm == 0 && std::regex_search(line, match, arch))
      listing.sm = static_cast<unsigned>(std::stoul(match[1]));
    if (std::regex_search(line, match, first)) {
      ListedInstruction i;
      i.address = static_cast<std::uint32_t>(std::stoul(match[1], nullptr, 16));
      i.guard = match[2];
      i.guard.erase(i.guard.find_last_not_of(' ') + 1);
      i.mnemonic = match[3];
      i.operands = match[4];
      i.low = std::stoull(match[5], nullptr, 16);
      if (i.address == 0) listing.kernels.push_back({pending_name, {}, {}});
      for (const std::string& of : pending_labels) listing.kernels.back().labels[of] = i.address;
      pending_labels.clear();
      listing.kernels.back().instructions.push_back(i);
    } else if (std::regex_search(line, match, second)) {
      if (!listing.kernels.empty())
        listing.kernels.back().instructions.back().high = std::stoull(match[1], nullptr, 16);
    } else if (std::regex_search(line, match, label)) {
      pending_labels.push_back(match[1]);
    } else if (std::regex_search(line, match, name)) {
      pending_name = match[1];
    }
  }
  return listing;
}

}  // namespace warpgrain::profiler::sass
