#include "profiler/safety/access_history.hpp"

#include <algorithm>
#include <bit>

namespace warpgrain::profiler {
namespace {

// A cell: item, time and site of the last visit, and two marks.
constexpr unsigned time_at = 32, site_at = time_at + GroupClock::bits;
constexpr std::uint64_t mark_a = std::uint64_t{1} << 62, mark_b = std::uint64_t{1} << 63;
constexpr std::uint64_t ordered = mark_a;      // of writes: it was
constexpr std::uint64_t many_items = mark_a;   // of reads: others of the group, too, and side by side
constexpr std::uint64_t many_groups = mark_b;  // of reads: other groups, too

std::uint32_t item_of(std::uint64_t cell) { return static_cast<std::uint32_t>(cell); }
std::uint32_t site_of(std::uint64_t cell) {
  return static_cast<std::uint32_t>(cell >> site_at) & AccessHistory::unknown_site;
}
bool in_group(std::uint64_t cell, const Visit& visit) {
  return item_of(cell) - visit.group_first < visit.group_size;
}
// Of a visit by the same group: whether the group's clock puts the cell's before it.
bool came_before(std::uint64_t cell, const Visit& visit) {
  return visit.clock->ordered(item_of(cell) - visit.group_first, visit.item - visit.group_first,
                              cell >> time_at & (GroupClock::period - 1));
}

std::uint64_t load(const std::uint64_t& cell) { return __atomic_load_n(&cell, __ATOMIC_SEQ_CST); }

}  // namespace

AccessHistory::AccessHistory(std::uint64_t bytes, std::uint32_t granule, std::uint32_t vector_bytes,
                             bool has_reads, bool concurrent, bool per_group)
    : shift_(static_cast<std::uint32_t>(std::countr_zero(granule))),
      vector_bytes_(vector_bytes > granule ? vector_bytes : 0),
      bytes_(bytes),
      has_reads_(has_reads),
      concurrent_(concurrent),
      per_group_(per_group),
      writes_((bytes >> shift_) + 1),
      reads_(has_reads ? (bytes >> shift_) + 1 : 0) {}

AccessHistory::Cell AccessHistory::pack(const Visit& visit) {
  return visit.item | (visit.clock->now() % GroupClock::period) << time_at |
         std::uint64_t{std::min(visit.site, unknown_site)} << site_at;
}

AccessHistory::Cell AccessHistory::exchange(Cell& cell, Cell value) const {
  if (concurrent_) return __atomic_exchange_n(&cell, value, __ATOMIC_SEQ_CST);
  return std::exchange(cell, value);
}

// Whether nothing orders what the cell remembers and the visit, whoever it was.
bool AccessHistory::parallel(Cell cell, const Visit& visit) const {
  if (item_of(cell) == 0) return false;
  return in_group(cell, visit) ? !came_before(cell, visit) : !per_group_;
}

std::optional<RaceFound> AccessHistory::against_write(Cell last, const Visit& visit) const {
  if (item_of(last) == visit.item || ((last & ordered) != 0 && visit.ordered) || !parallel(last, visit))
    return std::nullopt;
  return RaceFound{item_of(last), site_of(last)};
}

std::optional<RaceFound> AccessHistory::against_reads(Cell reads, const Visit& visit) const {
  if (!per_group_ && (reads & many_groups) != 0)
    return RaceFound{in_group(reads, visit) ? 0 : item_of(reads), site_of(reads)};
  if (!parallel(reads, visit)) return std::nullopt;
  if (item_of(reads) != visit.item) return RaceFound{item_of(reads), site_of(reads)};
  if ((reads & many_items) != 0) return RaceFound{0, site_of(reads)};
  return std::nullopt;
}

AccessHistory::Cell AccessHistory::with_read(Cell reads, const Visit& visit) const {
  Cell cell = pack(visit);
  if (item_of(reads) == 0) return cell;
  cell |= reads & many_groups;
  if (!in_group(reads, visit)) return cell | many_groups;
  if (!came_before(reads, visit)) {
    cell |= reads & many_items;
    if (item_of(reads) != visit.item) cell |= many_items;
  }
  return cell;
}

template <class Look>
std::optional<RaceFound> AccessHistory::look_at_siblings(std::uint64_t offset, std::uint32_t bytes,
                                                         Look&& look) const {
  if (bytes >= vector_bytes_) return std::nullopt;
  const std::uint64_t first = offset / vector_bytes_ * vector_bytes_;
  const std::uint64_t end = std::min(first + vector_bytes_, bytes_);
  for (std::uint64_t at = first; at < end; at += std::uint64_t{1} << shift_) {
    if (at >= offset && at < offset + bytes) continue;
    if (std::optional<RaceFound> found = look(at >> shift_)) {
      found->of_components = true;
      return found;
    }
  }
  return std::nullopt;
}

std::optional<RaceFound> AccessHistory::write(std::uint64_t offset, std::uint32_t bytes, const Visit& visit,
                                              const WrittenValues& values) {
  std::optional<RaceFound> found;
  const Cell mine = pack(visit);
  for (std::uint64_t piece = offset >> shift_; piece <= (offset + bytes - 1) >> shift_; ++piece) {
    Cell cell = mine;
    if (visit.ordered) {
      // A plain write stays one when its work-item goes on with atomics, until it has met others.
      const Cell before = load(writes_[piece]);
      if (item_of(before) != visit.item || (before & ordered) != 0 || came_before(before, visit))
        cell |= ordered;
    }
    const Cell last = exchange(writes_[piece], cell);
    if (last != 0 && !found) {
      found = against_write(last, visit);
      if (found && !visit.ordered && (last & ordered) == 0 && values.same(bytes)) found.reset();
    }
    if (!has_reads_ || found) continue;
    if (const Cell reads = load(reads_[piece]); reads != 0) found = against_reads(reads, visit);
  }
  if (found || visit.ordered) return found;
  return look_at_siblings(offset, bytes, [&](std::uint64_t piece) {
    const auto of_write = against_write(load(writes_[piece]), visit);
    return of_write || !has_reads_ ? of_write : against_reads(load(reads_[piece]), visit);
  });
}

std::optional<RaceFound> AccessHistory::read(std::uint64_t offset, std::uint32_t bytes, const Visit& visit) {
  std::optional<RaceFound> found;
  for (std::uint64_t piece = offset >> shift_; piece <= (offset + bytes - 1) >> shift_; ++piece) {
    if (!visit.ordered) {
      Cell before = load(reads_[piece]);
      if (concurrent_) {
        while (!__atomic_compare_exchange_n(&reads_[piece], &before, with_read(before, visit), true,
                                            __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST)) {
        }
      } else {
        reads_[piece] = with_read(before, visit);
      }
    }
    if (!found) found = against_write(load(writes_[piece]), visit);
  }
  if (found || visit.ordered) return found;
  return look_at_siblings(offset, bytes,
                          [&](std::uint64_t piece) { return against_write(load(writes_[piece]), visit); });
}

bool AccessHistory::written_by_group(std::uint64_t offset, std::uint32_t bytes, const Visit& visit) const {
  for (std::uint64_t piece = offset >> shift_; piece <= (offset + bytes - 1) >> shift_; ++piece)
    if (item_of(writes_[piece]) == 0 || !in_group(writes_[piece], visit)) return false;
  return true;
}

}  // namespace warpgrain::profiler
