#pragma once
// Who touched each piece of a stretch of memory last: finds data races.
//
// Two work-items race when they touch the same bytes, one of them writes, not both do so in order (atomics),
// and they have not met in between at a barrier of their work-group. Of the accesses to a piece the last
// write and the last read are kept, with a mark where work-items read side by side. Work-groups are never
// ordered.

#include <cstdint>
#include <cstring>
#include <optional>

#include "profiler/safety/group_clock.hpp"
#include "profiler/safety/zero_pages.hpp"

namespace warpgrain::profiler {

// Who touches memory, and when.
struct Visit {
  std::uint32_t item = 0;         // number of the work-item in the launch, counted group by group from 1
  std::uint32_t group_first = 0;  // number of the first work-item in its group
  std::uint32_t group_size = 0;
  const GroupClock* clock = nullptr;  // of its group
  std::uint32_t site = 0;
  bool ordered = false;  // atomic, or ordered like one
};

// What a write finds and what it leaves.
struct WrittenValues {
  const void* before = nullptr;
  const void* after = nullptr;  // null: of an atomic, not known
  bool same(std::size_t bytes) const { return after != nullptr && std::memcmp(before, after, bytes) == 0; }
};

struct RaceFound {
  std::uint32_t item = 0;  // of the other; 0: one of several that read
  std::uint32_t site = 0;
  bool of_components = false;  // other bytes of the same vector
};

class AccessHistory {
 public:
  static constexpr std::uint32_t unknown_site = 0x7FFF;  // and above, of kernels with so many

  // Of `bytes` bytes in pieces of `granule` (a power of two, at most 16), which no access is smaller than.
  // Races between the components of vectors of `vector_bytes` are looked for, too; 0: none. `has_reads`:
  // whether read() will be called. `concurrent`: several threads visit. `per_group`: what another work-group
  // did is forgotten, as with shared memory.
  AccessHistory(std::uint64_t bytes, std::uint32_t granule, std::uint32_t vector_bytes, bool has_reads,
                bool concurrent, bool per_group);

  // Of an access to [offset, offset + bytes), a power of two of bytes and aligned to that. A plain write of
  // the bytes that are there does no harm to another one.
  std::optional<RaceFound> write(std::uint64_t offset, std::uint32_t bytes, const Visit& visit,
                                 const WrittenValues& values);
  std::optional<RaceFound> read(std::uint64_t offset, std::uint32_t bytes, const Visit& visit);
  // Whether the visitor's group has written all of it.
  bool written_by_group(std::uint64_t offset, std::uint32_t bytes, const Visit& visit) const;

 private:
  using Cell = std::uint64_t;

  static Cell pack(const Visit& visit);
  bool parallel(Cell cell, const Visit& visit) const;
  std::optional<RaceFound> against_write(Cell last, const Visit& visit) const;
  std::optional<RaceFound> against_reads(Cell reads, const Visit& visit) const;
  Cell with_read(Cell reads, const Visit& visit) const;
  Cell exchange(Cell& cell, Cell value) const;
  template <class Look>
  std::optional<RaceFound> look_at_siblings(std::uint64_t offset, std::uint32_t bytes, Look&& look) const;

  std::uint32_t shift_;  // log2 of the granule
  std::uint32_t vector_bytes_;
  std::uint64_t bytes_;
  bool has_reads_, concurrent_, per_group_;
  ZeroPages<Cell> writes_, reads_;  // [pieces]; 0: nobody yet
};

}  // namespace warpgrain::profiler
