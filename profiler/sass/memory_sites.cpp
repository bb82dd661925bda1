#include "profiler/sass/memory_sites.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "profiler/division_path.hpp"

namespace warpgrain::profiler::sass {
namespace {

// Loads, stores and atomic operations are matched each with their kind, in whatever space: an address that
// the assembler knows to be global needs no generic load.
enum class AccessKindOfSite : std::uint8_t { none, load, store, atomic };

AccessKindOfSite kind_of_access(InstructionClass c) {
  switch (c) {
    case InstructionClass::global_load:
    case InstructionClass::generic_load:
    case InstructionClass::shared_load:
      return AccessKindOfSite::load;
    case InstructionClass::global_store:
    case InstructionClass::generic_store:
    case InstructionClass::shared_store:
      return AccessKindOfSite::store;
    case InstructionClass::atomic:
      return AccessKindOfSite::atomic;
    default:
      return AccessKindOfSite::none;
  }
}

// Streams that stand at the same places share a queue.
void give_queues(MemorySites& sites) {
  using Places = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // blocks of the PTX, accesses
  std::vector<Places> places(sites.streams.size());
  for (std::uint32_t b = 0; b < sites.of_access.size(); ++b)
    for (std::uint32_t k = 0; k < sites.of_access[b].size(); ++k)
      if (sites.of_access[b][k] != no_stream) places[sites.of_access[b][k]].emplace_back(b, k);
  std::map<Places, std::uint32_t> queue_of;  // by the places without the first one's access
  sites.queues_of.resize(sites.of_access.size());
  for (std::uint32_t s = 0; s < sites.streams.size(); ++s) {
    AccessStream& stream = sites.streams[s];
    const std::uint32_t offset = places[s][0].second;
    const bool same =
        std::ranges::all_of(places[s], [&](const auto& place) { return place.second == offset; });
    stream.offset = same ? offset : 0;
    if (same)
      for (auto& place : places[s]) place.second = 0;
    const auto [found, is_new] = queue_of.try_emplace(places[s], sites.n_queues);
    stream.queue = found->second;
    if (!is_new) continue;
    ++sites.n_queues;
    for (const auto& [block, access] : places[s]) sites.queues_of[block].push_back({stream.queue, access});
  }
}

}  // namespace

MemorySites find_memory_sites(const CodeGraph& code, const PtxDecisions& decisions) {
  MemorySites sites;
  std::unordered_map<std::uint32_t, std::uint32_t> by_line;
  for (const BasicBlock& block : decisions.graph().blocks) {
    std::vector<std::uint32_t>& streams = sites.of_access.emplace_back();
    for (const MemoryAccess& access : block.accesses) {
      if (is_path(access)) {
        streams.push_back(no_stream);
        continue;
      }
      const profiler::Instruction& instruction = block.instructions[access.instruction];
      const auto [found, is_new] =
          by_line.try_emplace(instruction.ptx_line, static_cast<std::uint32_t>(sites.streams.size()));
      if (is_new)
        sites.streams.push_back(
            {access.access, access.bytes, instruction.text.starts_with('@'), 0, 0, false, {}});
      streams.push_back(found->second);
    }
  }
  for (const CodeBlock& block : code.blocks) {
    std::vector<MemorySite>& of_block = sites.of_block.emplace_back();
    for (std::uint32_t k = block.first; k < block.last; ++k) {
      const Instruction& instruction = code.instructions[k];
      const auto found = by_line.find(instruction.line);
      if (found == by_line.end()) continue;
      AccessStream& stream = sites.streams[found->second];
      const AccessKindOfSite kind = kind_of_access(instruction.instruction_class);
      if (kind == AccessKindOfSite::none || kind != kind_of_access(stream.access)) continue;
      stream.has_site = true;
      const bool guarded = instruction.guard != always && !stream.predicated;
      of_block.push_back({found->second, guarded});
    }
  }
  give_queues(sites);
  for (AccessStream& stream : sites.streams)
    for (std::uint32_t s = 0; stream.has_site && s < sites.streams.size(); ++s) {
      const AccessStream& other = sites.streams[s];
      if (!other.has_site && other.access == stream.access && other.bytes == stream.bytes)
        stream.without_site.push_back(s);
    }
  return sites;
}

}  // namespace warpgrain::profiler::sass
