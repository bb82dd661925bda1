#include "profiler/observers/footprint.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "profiler/coalescing.hpp"

namespace warpgrain::profiler {

TouchedSectors::TouchedSectors(std::span<const KernelArgument> arguments) {
  for (const KernelArgument& argument : arguments) {
    if (argument.kind != KernelArgument::Kind::buffer || argument.memory.empty()) continue;
    const auto begin = reinterpret_cast<std::uint64_t>(argument.memory.data());
    buffers_.push_back({begin / sector_bytes * sector_bytes, begin + argument.memory.size(), 0});
  }
  // A buffer may be given twice.
  std::ranges::sort(buffers_, {}, &Buffer::begin);
  std::uint64_t sectors = 0, covered = 0;
  for (Buffer& buffer : buffers_) {
    buffer.begin = std::max(buffer.begin, (covered + sector_bytes - 1) / sector_bytes * sector_bytes);
    buffer.first_sector = sectors;
    covered = std::max(covered, buffer.end);
    if (buffer.end > buffer.begin) sectors += (buffer.end - buffer.begin + sector_bytes - 1) / sector_bytes;
  }
  sectors_ = std::vector<Sector>(sectors);
}

std::uint64_t TouchedSectors::sector_of(std::uint64_t address) const {
  auto after = std::ranges::upper_bound(buffers_, address, {}, &Buffer::begin);
  while (after != buffers_.begin()) {
    const Buffer& buffer = *--after;
    if (address < buffer.end) return buffer.first_sector + (address - buffer.begin) / sector_bytes;
    if (buffer.end > buffer.begin) break;  // one that another covers says nothing
  }
  return no_sector;
}

void TouchedSectors::loaded(std::uint64_t sector) {
  sectors_[sector].loaded.store(true, std::memory_order_relaxed);
}

void TouchedSectors::stored(std::uint64_t sector, std::uint32_t bytes) {
  std::atomic<std::uint32_t>& stored = sectors_[sector].stored_bytes;
  if ((stored.load(std::memory_order_relaxed) & bytes) != bytes)
    stored.fetch_or(bytes, std::memory_order_relaxed);
}

void TouchedSectors::updated(std::uint64_t sector) {
  sectors_[sector].updated.store(true, std::memory_order_relaxed);
}

void TouchedSectors::count(FootprintCounters& counters) const {
  for (const Sector& sector : sectors_) {
    const std::uint32_t stored = sector.stored_bytes;
    const bool loaded = sector.loaded;
    counters.load_sectors += loaded ? 1 : 0;
    counters.store_sectors += stored != 0 ? 1 : 0;
    counters.part_stored_sectors +=
        stored != 0 && stored != std::numeric_limits<std::uint32_t>::max() ? 1 : 0;
    counters.sectors += loaded || stored != 0 ? 1 : 0;
  }
}

TouchedMemory TouchedSectors::all() const {
  TouchedMemory memory;
  for (const Buffer& buffer : buffers_)
    for (std::uint64_t address = buffer.begin; address < buffer.end; address += sector_bytes) {
      const Sector& sector = sectors_[buffer.first_sector + (address - buffer.begin) / sector_bytes];
      if (sector.loaded || sector.updated || sector.stored_bytes != 0) add_sector(memory, address);
    }
  return memory;
}

bool DistinctNumbers::insert(std::uint64_t number) {
  if (2 * n_ >= slots_.size()) grow();
  const std::uint64_t mask = slots_.size() - 1;
  // Numbers beside each other go to slots beside each other.
  for (std::uint64_t at = (number ^ (number >> 20)) & mask;; at = (at + 1) & mask) {
    Slot& slot = slots_[at];
    if (slot.round != round_) {
      slot = {number, round_};
      ++n_;
      return true;
    }
    if (slot.number == number) return false;
  }
}

void DistinctNumbers::clear() {
  ++round_;
  n_ = 0;
}

void DistinctNumbers::grow() {
  std::vector<Slot> slots(2 * slots_.size());
  std::swap(slots, slots_);
  const std::uint64_t round = round_;
  clear();
  for (const Slot& slot : slots)
    if (slot.round == round) insert(slot.number);
}

void FootprintVisitor::visit(std::uint64_t, std::span<const LaneTrace> lanes) {
  loaded_.clear();
  stored_.clear();
  for (const LaneTrace& lane : lanes)
    if (lane.blocks != nullptr) walk(lane);
}

void FootprintVisitor::load(std::uint64_t address, std::uint32_t bytes) {
  for (std::uint64_t at = address; at < address + bytes; at = (at / sector_bytes + 1) * sector_bytes) {
    const std::uint64_t sector = touched_->sector_of(at);
    if (sector == TouchedSectors::no_sector || !loaded_.insert(sector)) continue;
    ++group_load_sectors;
    touched_->loaded(sector);
  }
}

void FootprintVisitor::store(std::uint64_t address, std::uint32_t bytes) {
  for (std::uint64_t at = address; at < address + bytes;) {
    const std::uint64_t next = std::min((at / sector_bytes + 1) * sector_bytes, address + bytes);
    const std::uint64_t sector = touched_->sector_of(at);
    if (sector != TouchedSectors::no_sector) {
      group_store_sectors += stored_.insert(sector) ? 1 : 0;
      const std::uint64_t ones = (std::uint64_t{1} << (next - at)) - 1;
      touched_->stored(sector, static_cast<std::uint32_t>(ones << at % sector_bytes));
    }
    at = next;
  }
}

void FootprintVisitor::update(std::uint64_t address, std::uint32_t bytes) {
  for (std::uint64_t at = address; at < address + bytes; at = (at / sector_bytes + 1) * sector_bytes)
    if (const std::uint64_t sector = touched_->sector_of(at); sector != TouchedSectors::no_sector)
      touched_->updated(sector);
}

void FootprintVisitor::walk(const LaneTrace& lane) {
  const std::uint64_t* address = lane.addresses;
  const BlockIndex* recorded = lane.blocks;
  for (std::uint32_t b = *recorded++; b != trace_end;) {
    const BasicBlock& block = graph_->blocks[b];
    for (const MemoryAccess& access : block.accesses) {
      const std::uint64_t first = *address++;
      if (first == no_address) continue;
      switch (access.access) {
        case InstructionClass::global_load:
        case InstructionClass::generic_load:
          load(first, access.bytes);
          break;
        case InstructionClass::global_store:
        case InstructionClass::generic_store:
          store(first, access.bytes);
          break;
        case InstructionClass::atomic:
          update(first, access.bytes);
          break;
        default:
          break;
      }
    }
    if (block.successors.empty()) return;
    const bool follows = block.successors.size() == 1 && !graph_->blocks[block.successors[0]].recorded;
    b = follows ? block.successors[0] : *recorded++;
  }
}

FootprintCounters LaunchFootprint::counters() const {
  FootprintCounters counters;
  for (const FootprintVisitor& visitor : visitors_) {
    counters.group_load_sectors += visitor.group_load_sectors;
    counters.group_store_sectors += visitor.group_store_sectors;
  }
  touched_.count(counters);
  return counters;
}

}  // namespace warpgrain::profiler
