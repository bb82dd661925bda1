#include "profiler/sass/request_counter.hpp"

#include <algorithm>
#include <bit>
#include <span>

#include "profiler/observers/warp_counters.hpp"

namespace warpgrain::profiler::sass {

void RequestCounters::add(const RequestCounters& other) {
  for (std::size_t s = 0; s < requests.size(); ++s) {
    requests[s].add(other.requests[s]);
    unmatched[s] += other.unmatched[s];
    borrowed[s] += other.borrowed[s];
  }
}

RequestCounter::RequestCounter(const MemorySites& sites, const PtxDecisions& decisions,
                               RequestCounters& counters)
    : sites_(sites),
      counters_(counters),
      queues_(std::size_t{sites.n_queues} * 32),
      next_(sites.streams.size() * 32) {
  for (std::uint32_t b = 0; b < sites.of_access.size(); ++b) {
    Run run;
    run.first_push = static_cast<std::uint32_t>(pushes_.size());
    decisions.for_run(b, [&](std::uint32_t on_run) {
      for (const MemorySites::QueueEntry& entry : sites.queues_of[on_run])
        pushes_.push_back({entry.queue, run.n_addresses + entry.first});
      run.n_addresses += static_cast<std::uint32_t>(sites.of_access[on_run].size());
    });
    run.last_push = static_cast<std::uint32_t>(pushes_.size());
    run.adds = run.first_push != run.last_push ? 1 : 0;
    runs_.push_back(run);
  }
  for (const std::vector<MemorySite>& of_block : sites.of_block)
    needs_ahead_.push_back(std::ranges::any_of(of_block, [&](const MemorySite& site) {
      return site.guarded || !sites.streams[site.stream].without_site.empty();
    }));
}

bool RequestCounter::ever_needs_ahead() const {
  return std::ranges::find(needs_ahead_, true) != needs_ahead_.end();
}

void RequestCounter::begin_warp(std::span<const LaneTrace> lanes) {
  has_addresses_ =
      std::ranges::any_of(lanes, [](const LaneTrace& lane) { return lane.addresses != nullptr; });
  if (!has_addresses_) return;
  for (std::vector<Noted>& queue : queues_) queue.clear();
  for (std::uint32_t lane = 0; lane < lanes.size(); ++lane)
    if (lanes[lane].blocks != nullptr) add_lane(lane, lanes[lane]);
  for (std::vector<Noted>& queue : queues_) queue.push_back({0, no_entry});
  for (std::uint32_t s = 0; s < sites_.streams.size(); ++s)
    for (std::uint32_t lane = 0; lane < 32; ++lane)
      next_[s * 32 + lane] = queues_[sites_.streams[s].queue * 32 + lane].data();
}

void RequestCounter::add_lane(std::uint32_t lane, const LaneTrace& trace) {
  traced_[lane] = trace.addresses;
  // Members are copied so that they stay in registers.
  const Run* const runs = runs_.data();
  const Push* const pushes = pushes_.data();
  std::vector<Noted>* const queues = queues_.data() + lane;
  // First those that add anything, without branches: which these are cannot be foretold.
  Noted* adding = adding_.data();
  std::size_t n = 0, room = adding_.size();
  std::uint32_t address = 0;
  for (std::uint32_t entry = 0; trace.blocks[entry] != trace_end; ++entry) {
    const Run& run = runs[trace.blocks[entry]];
    adding[n] = {address, entry};
    n += run.adds;
    address += run.n_addresses;
    if (n < room) continue;
    adding_.resize(room *= 2);
    adding = adding_.data();
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Run& run = runs[trace.blocks[adding[k].entry]];
    for (std::uint32_t p = run.first_push; p < run.last_push; ++p)
      queues[std::size_t{pushes[p].queue} * 32].push_back(
          {adding[k].address + pushes[p].offset, adding[k].entry});
  }
}

// Adds the next address of each lane.
inline void RequestCounter::take_next(std::uint32_t stream, std::uint32_t lanes,
                                      std::array<std::uint64_t, 32>& addresses, std::size_t& n) {
  const Noted** const next = &next_[stream * 32];
  const std::uint32_t offset = sites_.streams[stream].offset;
  for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
    if (next[lane]->entry == no_entry) {
      ++counters_.unmatched[stream];
      continue;
    }
    addresses[n] = traced_[lane][next[lane]++->address + offset];
    n += addresses[n] != no_address ? 1 : 0;
  }
}

// The lane's next access at the site, of the stream itself or of one that shares its instruction.
std::uint64_t RequestCounter::take(const MemorySite& site, std::uint32_t lane, std::uint32_t ahead) {
  const Noted* chosen = next(site.stream, lane);
  std::uint32_t from = site.stream;
  if (chosen == nullptr || chosen->entry >= ahead)
    for (const std::uint32_t stream : sites_.streams[site.stream].without_site) {
      const Noted* other = next(stream, lane);
      if (other == nullptr || (chosen != nullptr && (other->entry >= ahead || other->entry >= chosen->entry)))
        continue;
      chosen = other;
      from = stream;
    }
  if (site.guarded && (chosen == nullptr || chosen->entry >= ahead)) return no_address;
  if (from != site.stream) ++counters_.borrowed[from];
  std::array<std::uint64_t, 32> address{};
  std::size_t n = 0;
  take_next(chosen == nullptr ? site.stream : from, 1U << lane, address, n);
  return n == 0 ? no_address : address[0];
}

void RequestCounter::count(std::uint32_t block, std::uint32_t lanes,
                           const std::array<std::uint32_t, 32>& ahead) {
  if (!has_addresses_) return;
  for (const MemorySite& site : sites_.of_block[block]) {
    std::array<std::uint64_t, 32> addresses;
    std::size_t n = 0;
    const AccessStream& stream = sites_.streams[site.stream];
    const bool simple = !site.guarded && stream.without_site.empty();
    if (simple) {
      take_next(site.stream, lanes, addresses, n);
    } else {
      for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
        addresses[n] = take(site, lane, ahead[lane]);
        n += addresses[n] != no_address ? 1 : 0;
      }
    }
    count_request(counters_.requests[site.stream], std::span(addresses).first(n), stream.bytes);
  }
}

void RequestCounter::end_warp() {
  if (!has_addresses_) return;
  for (std::uint32_t s = 0; s < sites_.streams.size(); ++s)
    for (std::uint32_t lane = 0; lane < 32; ++lane)
      counters_.unmatched[s] += static_cast<std::uint64_t>(
          &queues_[sites_.streams[s].queue * 32 + lane].back() - next_[s * 32 + lane]);
}

}  // namespace warpgrain::profiler::sass
