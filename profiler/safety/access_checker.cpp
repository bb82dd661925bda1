#include "profiler/safety/access_checker.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace warpgrain::profiler {
namespace {

constexpr std::uint64_t first_page = 4096;
constexpr std::string_view private_variables = "private variables";

std::string_view kind_name(AccessKind kind) {
  return kind == AccessKind::load ? "load" : kind == AccessKind::store ? "store" : "atomic";
}

std::string_view space_name(AccessSpace space) {
  static constexpr std::array<std::string_view, 6> names{"generic",  "global", "shared",
                                                         "constant", "local",  "parameter"};
  return names[static_cast<std::size_t>(space)];
}

// clang calls the variable `name` of kernel `k` "k_$_name".
std::string name_in_source(const std::string& name) {
  constexpr std::string_view mark = "_$_";
  const std::size_t at = name.find(mark);
  return at == std::string::npos ? name : name.substr(at + mark.size());
}

// Constant buffers lie in global memory.
bool fits_space(AccessSpace of_site, AccessSpace of_region) {
  const auto plain = [](AccessSpace s) { return s == AccessSpace::constant ? AccessSpace::global : s; };
  return of_site == AccessSpace::generic || plain(of_site) == plain(of_region);
}

}  // namespace

AccessChecker::AccessChecker(LaunchMonitor& monitor, std::span<const std::byte> parameters,
                             std::span<const std::byte> shared, std::span<const std::size_t> shared_offsets)
    : monitor_(monitor),
      kernel_(monitor.kernel()),
      bounds_(kernel_.memory.sites.size()),
      regions_(kernel_.memory.sites.size(), nullptr),
      clock_(monitor.shape().work_group_size()),
      lane_synchronized_(monitor.shape().work_group_size()) {
  parameters_.begin = reinterpret_cast<std::uintptr_t>(parameters.data());
  parameters_.size = parameters.size();
  parameters_.name = "parameters";
  parameters_.space = AccessSpace::parameter;
  parameters_.writable = false;
  add_shared_regions(shared, shared_offsets);
  for (std::uint32_t i = 0; i < kernel_.memory.sites.size(); ++i) {
    const std::uint32_t object = kernel_.memory.sites[i].object;
    if (object == AccessSite::any_object || kernel_.memory.objects[object].kind == MemoryObject::Kind::local)
      continue;
    const auto own = std::find(shared_objects_.begin(), shared_objects_.end(), object);
    bind(i, own == shared_objects_.end() ? monitor.memory().region_of(object)
                                         : shared_[static_cast<std::size_t>(own - shared_objects_.begin())]);
  }
}

void AccessChecker::add_shared_regions(std::span<const std::byte> shared,
                                       std::span<const std::size_t> shared_offsets) {
  const auto begin = reinterpret_cast<std::uintptr_t>(shared.data());
  const auto arguments = monitor_.arguments();
  for (std::uint32_t o = 0; o < kernel_.memory.objects.size(); ++o) {
    const MemoryObject& object = kernel_.memory.objects[o];
    MemoryRegion region;
    region.space = AccessSpace::shared;
    region.name = name_in_source(object.name);
    region.state = &shared_state_;
    if (object.kind == MemoryObject::Kind::shared) {
      region.begin = begin + object.offset;
      region.size = object.bytes;
    } else if (object.kind == MemoryObject::Kind::parameter &&
               arguments[object.offset].kind == KernelArgument::Kind::local) {
      region.begin = begin + shared_offsets[object.offset];
      region.size = arguments[object.offset].local_bytes;
      if (!arguments[object.offset].name.empty()) region.name = arguments[object.offset].name;
    } else {
      continue;
    }
    shared_.push_back(region);
    shared_objects_.push_back(o);
  }
  if (shared.empty()) return;
  std::uint32_t granule = 16;
  for (const AccessSite& site : kernel_.memory.sites)
    if (site.space == AccessSpace::shared || site.space == AccessSpace::generic)
      granule = std::min<std::uint32_t>(granule, site.bytes);
  shared_state_.begin = begin;
  shared_state_.end = begin + shared.size();
  shared_state_.history = std::make_unique<AccessHistory>(shared.size(), granule, 0, true, false, true);
}

// From here on accesses of the site go to the region without a closer look, where they may.
void AccessChecker::bind(std::uint32_t index, const MemoryRegion& region) {
  const AccessSite& site = kernel_.memory.sites[index];
  regions_[index] = &region;
  bounds_[index] = {};
  if (!region.state && may_go(site, region) && region.begin % site.bytes == 0)
    bounds_[index] = {region.begin, region.size / site.bytes};
}

bool AccessChecker::may_go(const AccessSite& site, const MemoryRegion& region) const {
  return fits_space(site.space, region.space) && (site.kind == AccessKind::store || region.readable) &&
         (site.kind == AccessKind::load || region.writable);
}

void AccessChecker::place(LaneContext& lane) {
  lane.bounds = bounds_.data();
  lane.checker = this;
  lane.look_closer = look_closer;
  lane.readable = readable;
}

void AccessChecker::begin_group(std::uint64_t number) {
  first_item_ = number * lane_synchronized_.size();
  clock_.reset();
  std::fill(lane_synchronized_.begin(), lane_synchronized_.end(), false);
  group_synchronized_ = false;
}

void AccessChecker::lanes_met(std::span<const std::size_t> lanes, bool of_warp) {
  clock_.meet(lanes, of_warp);
  if (!kernel_.memory.has_fence) return;
  group_synchronized_ |=
      std::find(lane_synchronized_.begin(), lane_synchronized_.end(), true) != lane_synchronized_.end();
}

std::byte* AccessChecker::look_closer(LaneContext* lane, std::uint32_t site, std::uint64_t address) {
  auto& self = *static_cast<AccessChecker*>(lane->checker);
  return self.look({self.kernel_.memory.sites[site], site, address, *lane});
}

std::uint64_t AccessChecker::readable(const LaneContext* lane, std::uint64_t address) {
  const MemoryRegion* region = static_cast<AccessChecker*>(lane->checker)->find(*lane, address);
  return region && region->readable ? region->begin + region->size - address : 0;
}

std::byte* AccessChecker::look(const Access& access) {
  const MemoryRegion* region = region_of(access);
  if (!region || !region->holds(access.address, access.site.bytes) ||
      access.address % access.site.bytes != 0 || !may_go(access.site, *region))
    return refuse(access, region);
  if (region->state) {
    if (region->state->initialized) look_at_initialization(access, *region);
    if (region->state->history) look_at_history(access, *region);
  }
  return reinterpret_cast<std::byte*>(access.address);
}

const MemoryRegion* AccessChecker::region_of(const Access& access) {
  const std::uint32_t object = access.site.object;
  if (object == AccessSite::any_object) {
    const MemoryRegion* last = regions_[access.index];
    if (last && last->holds(access.address, 1)) return last;
    const MemoryRegion* found = find(access.lane, access.address);
    if (found && found != &local_) bind(access.index, *found);
    return found;
  }
  if (kernel_.memory.objects[object].kind != MemoryObject::Kind::local) return regions_[access.index];
  local_ = local_region(access.lane, &kernel_.memory.objects[object]);
  return &local_;
}

const MemoryRegion* AccessChecker::find(const LaneContext& lane, std::uint64_t address) {
  local_ = local_region(lane, nullptr);
  if (local_.holds(address, 1)) return &local_;
  if (parameters_.holds(address, 1)) return &parameters_;
  for (const MemoryRegion& shared : shared_)
    if (shared.holds(address, 1)) return &shared;
  return monitor_.memory().find(address);
}

MemoryRegion AccessChecker::local_region(const LaneContext& lane, const MemoryObject* object) const {
  MemoryRegion region;
  region.begin = reinterpret_cast<std::uintptr_t>(lane.local) + (object ? object->offset : 0);
  region.size = object ? object->bytes : kernel_.local_bytes;
  region.space = AccessSpace::local;
  // clang keeps what does not fit registers in one variable.
  region.name = object && !object->name.starts_with("__local_depot") ? object->name : private_variables;
  return region;
}

void AccessChecker::look_at_initialization(const Access& access, const MemoryRegion& region) {
  std::uint8_t* const known = region.state->initialized.data() + (access.address - region.state->begin);
  for (std::uint32_t i = 0; i < access.site.bytes; ++i) {
    if (access.site.kind != AccessKind::store && __atomic_load_n(known + i, __ATOMIC_RELAXED) == 0) {
      note(DiagnosticKind::uninitialized_read, access, &region);
      break;
    }
  }
  if (access.site.kind == AccessKind::load) return;
  for (std::uint32_t i = 0; i < access.site.bytes; ++i) __atomic_store_n(known + i, 1, __ATOMIC_RELAXED);
}

void AccessChecker::look_at_history(const Access& access, const MemoryRegion& region) {
  const AccessSite& site = access.site;
  AccessHistory& history = *region.state->history;
  const std::uint64_t offset = access.address - region.state->begin;
  const Visit visit = visit_of(access);
  if (region.space == AccessSpace::shared && site.kind != AccessKind::store &&
      !history.written_by_group(offset, site.bytes, visit))
    note(DiagnosticKind::uninitialized_read, access, &region);
  std::optional<RaceFound> race;
  if (site.kind == AccessKind::load) {
    race = history.read(offset, site.bytes, visit);
  } else {
    const void* const after = site.kind == AccessKind::store ? access.lane.stored : nullptr;
    race = history.write(offset, site.bytes, visit, {reinterpret_cast<const void*>(access.address), after});
  }
  const bool synchronized = group_synchronized_ || lane_synchronized_[access.lane.linear_tid];
  if (race && !synchronized)
    note(race->of_components ? DiagnosticKind::subvector_race : DiagnosticKind::data_race, access, &region,
         &*race);
  if (kernel_.memory.has_fence && site.ordered) lane_synchronized_[access.lane.linear_tid] = true;
}

Visit AccessChecker::visit_of(const Access& access) const {
  Visit visit;
  visit.item = static_cast<std::uint32_t>(item_of(access.lane)) + 1;
  visit.group_first = static_cast<std::uint32_t>(first_item_) + 1;
  visit.group_size = access.lane.work_group_size;
  visit.clock = &clock_;
  visit.site = access.index;
  visit.ordered = access.site.ordered;
  return visit;
}

// What is wrong with an access that may not go on; the worst first.
std::byte* AccessChecker::refuse(const Access& access, const MemoryRegion* region) {
  const AccessSite& site = access.site;
  if (region ? region->begin == 0 : access.address < first_page)
    return refuse(DiagnosticKind::null_pointer, access, region);
  if (!region || !region->holds(access.address, site.bytes) || !fits_space(site.space, region->space))
    return refuse(DiagnosticKind::out_of_bounds, access, region);
  if (access.address % site.bytes != 0) return refuse(DiagnosticKind::misaligned, access, region);
  return refuse(site.kind != AccessKind::load && !region->writable ? DiagnosticKind::read_only_write
                                                                   : DiagnosticKind::write_only_read,
                access, region);
}

std::byte* AccessChecker::refuse(DiagnosticKind kind, const Access& access, const MemoryRegion* region) {
  note(kind, access, region);
  nowhere_.fill(std::byte{0});
  return nowhere_.data();
}

void AccessChecker::note(DiagnosticKind kind, const Access& access, const MemoryRegion* region,
                         const RaceFound* race) {
  monitor_.note(kind, access.site.line, access.site.object, item_of(access.lane), [&](Diagnostic& d) {
    d.access = kind_name(access.site.kind);
    d.bytes = access.site.bytes;
    d.space = space_name(region ? region->space : access.site.space);
    if (region && region->begin != 0) d.offset = static_cast<std::int64_t>(access.address - region->begin);
    if (region) {
      d.buffer = region->name;
      d.buffer_bytes = region->size;
    } else if (kind == DiagnosticKind::out_of_bounds) {
      d.detail = "at an address in no buffer";
    }
    if (!race) return;
    OtherAccess other;
    if (race->item != 0) other.work_item = monitor_.global_id(race->item - 1);
    if (race->site < kernel_.memory.sites.size()) {
      const AccessSite& site = kernel_.memory.sites[race->site];
      other.place = kernel_.source_of(site.line);
      other.access = kind_name(site.kind);
    }
    d.other = std::move(other);
  });
}

}  // namespace warpgrain::profiler
