#include "tests/profiler/oracle/lockstep.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <set>
#include <stdexcept>

#include "tests/profiler/oracle/work_group.hpp"

namespace warpgrain::oracle {
namespace {

constexpr std::uint64_t max_issued = 100'000'000;  // of a launch; what needs more is taken for endless

class Warp {
 public:
  Warp(const Program& program, const Flow& flow, const Policy& policy, WorkGroup& lanes, std::uint32_t first,
       std::uint32_t width, Counts& counts)
      : program_(program),
        flow_(flow),
        lanes_(lanes),
        first_(first),
        alive_(all_of(std::min(width, lanes.size() - first))),
        schedule_(policy.schedule(alive_)),
        counts_(counts) {}

  // Runs to the next barrier, or to the end: then false.
  bool run() {
    for (;;) {
      if (!running_) {
        running_ = schedule_->next();
        if (!running_) return false;
        place_ = flow_.stretches()[running_->at].first;
      }
      const Stretch& stretch = flow_.stretches()[running_->at];
      while (place_ < stretch.last) {
        const Step& step = program_.steps[place_];
        issue(step);
        ++place_;
        if (step.kind != Step::Kind::barrier) continue;
        if (running_->lanes != alive_)
          throw std::runtime_error("a barrier that only some lanes of a warp reach together");
        return true;
      }
      schedule_->went(leave(stretch));
      running_.reset();
    }
  }
  Place waits_at() const { return place_; }

 private:
  static Lanes all_of(std::uint32_t n) { return n == 64 ? ~Lanes{0} : (Lanes{1} << n) - 1; }

  template <class F>
  void for_each(Lanes lanes, F&& function) const {
    for (; lanes != 0; lanes &= lanes - 1) function(static_cast<std::uint32_t>(std::countr_zero(lanes)));
  }

  void issue(const Step& step) {
    if (++counts_.issued > max_issued) throw std::runtime_error("an endless run");
    ++counts_.executions[place_][static_cast<std::size_t>(std::popcount(running_->lanes))];
    std::vector<std::uint64_t> addresses;
    for_each(running_->lanes, [&](std::uint32_t lane) {
      if (!lanes_.takes_part(step, first_ + lane)) return;
      if (step.counts_access) addresses.push_back(lanes_.address(step, first_ + lane));
      lanes_.execute(step, first_ + lane);
    });
    if (step.counts_access) count_access(step, addresses);
  }

  void count_access(const Step& step, const std::vector<std::uint64_t>& addresses) {
    AccessCount& count = counts_.accesses[place_];
    if (addresses.empty()) return;
    const std::size_t elements = step.kind == Step::Kind::load    ? step.outputs.size()
                                 : step.kind == Step::Kind::store ? step.inputs.size()
                                                                  : 1;
    const std::uint64_t bytes = step.element.bytes() * elements;
    std::set<std::uint64_t> sectors;
    for (const std::uint64_t address : addresses)
      for (std::uint64_t byte = address; byte < address + bytes; ++byte) sectors.insert(byte / 32);
    ++count.requests;
    count.sectors += sectors.size();
    count.useful_bytes += bytes * addresses.size();
    count.sectors_known &= std::all_of(addresses.begin(), addresses.end(), Memory::in_buffer);
  }

  // Where the lanes of the running group go from the end of the stretch.
  std::vector<Group> leave(const Stretch& stretch) {
    const Place place = stretch.last - 1;
    const Step& step = program_.steps[place];
    std::vector<Group> parts;
    for_each(running_->lanes, [&](std::uint32_t lane) {
      const Place to = lanes_.next(step, first_ + lane);
      const auto way = std::find(step.to.begin(), step.to.end(), to) - step.to.begin();
      if (step.to.size() > 1 && way == 0) ++counts_.taken_lanes[place];
      const Node at = stretch.to[static_cast<std::size_t>(way)];
      const auto part = std::find_if(parts.begin(), parts.end(), [&](const Group& g) { return g.at == at; });
      if (part == parts.end()) {
        parts.push_back({at, Lanes{1} << lane});
      } else {
        part->lanes |= Lanes{1} << lane;
      }
    });
    if (parts.size() > 1) ++counts_.divergent[place];
    std::erase_if(parts, [&](const Group& part) {
      if (part.at != flow_.end()) return false;
      alive_ &= ~part.lanes;
      return true;
    });
    return parts;
  }

  const Program& program_;
  const Flow& flow_;
  WorkGroup& lanes_;
  std::uint32_t first_;  // lane 0 of the warp, in the work-group
  Lanes alive_;
  std::unique_ptr<Schedule> schedule_;
  Counts& counts_;
  std::optional<Group> running_;
  Place place_ = 0;
};

// Lets all warps run from barrier to barrier.
void run_group(std::vector<Warp>& warps) {
  for (;;) {
    std::set<Place> waiting;
    std::size_t n_waiting = 0;
    for (Warp& warp : warps)
      if (warp.run()) {
        waiting.insert(warp.waits_at());
        ++n_waiting;
      }
    if (n_waiting == 0) return;
    if (n_waiting != warps.size() || waiting.size() != 1)
      throw std::runtime_error("a barrier that only some warps reach");
  }
}

}  // namespace

Counts run_lockstep(const Program& program, const Flow& flow, const Policy& policy, std::uint32_t warp_width,
                    const profiler::LaunchShape& shape, std::span<const profiler::KernelArgument> arguments) {
  Counts counts;
  counts.executions.assign(program.steps.size(), std::vector<std::uint64_t>(warp_width + 1));
  counts.divergent.resize(program.steps.size());
  counts.taken_lanes.resize(program.steps.size());

  Memory memory;
  std::vector<std::byte> variables = program.variables, parameters(program.parameter_bytes);
  memory.set(Memory::variables, variables);
  memory.set(Memory::parameters, parameters);
  std::uint64_t shared_bytes = program.shared_bytes;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::byte* const place = parameters.data() + program.parameter_offsets.at(i);
    if (arguments[i].kind == profiler::KernelArgument::Kind::scalar) {
      std::memcpy(place, arguments[i].value.data(), arguments[i].value.size());
      continue;
    }
    std::uint64_t address = 0;
    if (arguments[i].kind == profiler::KernelArgument::Kind::buffer) {
      address = memory.add_buffer(arguments[i].memory);
    } else {
      shared_bytes = (shared_bytes + 127) / 128 * 128;
      address = Memory::base_of(Memory::shared) + shared_bytes;
      shared_bytes += arguments[i].local_bytes;
    }
    std::memcpy(place, &address, sizeof address);
  }

  const auto groups = shape.group_count();
  for (std::uint64_t z = 0; z < groups[2]; ++z)
    for (std::uint64_t y = 0; y < groups[1]; ++y)
      for (std::uint64_t x = 0; x < groups[0]; ++x) {
        std::vector<std::byte> shared(shared_bytes);
        memory.set(Memory::shared, shared);
        WorkGroup lanes(program, memory, shape, {x, y, z});
        std::vector<Warp> warps;
        for (std::uint32_t first = 0; first < lanes.size(); first += warp_width)
          warps.emplace_back(program, flow, policy, lanes, first, warp_width, counts);
        run_group(warps);
      }
  return counts;
}

}  // namespace warpgrain::oracle
