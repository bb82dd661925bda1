#include "variants/device_simulation.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <numeric>
#include <string_view>

#include "core/error.hpp"
#include "kernels/layout.h"
#include "variants/combinations.hpp"
#include "variants/models.hpp"

namespace warpgrain {
namespace {

// Of the skin: as kernels/search/check_lists.cl has it.
constexpr double listed_share = 0.49;

// Steps between two looks at the device's errors: seldom enough to keep its queue filled.
constexpr std::uint64_t steps_between_checks = 16;

struct StatusMessage {
  std::size_t word;
  std::string_view text;
};
constexpr std::array<StatusMessage, 6> status_messages{{
    {STATUS_OUT_OF_DOMAIN, "left the domain"},
    {STATUS_NOT_FINITE, "has a position or a force that is not a finite number"},
    {STATUS_SLOTS_FULL, "has more contacts than contact slots"},
    {STATUS_FORCE_TOO_LARGE, "feels a force too large for fixed-point sums"},
    {STATUS_DISPLACEMENT_TOO_LARGE, "has a tangential displacement too large for half precision"},
    {STATUS_LIST_FULL, "has more neighbours than its list has room for"},
}};

Vector3d vector_at(const std::vector<double>& values, std::size_t k, std::size_t stride) {
  return {values[stride * k], values[stride * k + 1], values[stride * k + 2]};
}

}  // namespace

DeviceSimulation::DeviceSimulation(const Scene& scene, const Variant& variant, const BackendOptions& options,
                                   std::unique_ptr<ComputeDevice> device)
    : device_(std::move(device)),
      id_(scene.particles.id),
      material_(scene.particles.material),
      ranks_by_id_(id_.size()) {
  require_sensible(variant);
  if (!options.kernel_folder.empty() && !model_of(variant).is_full)
    throw_input_error("--kernels with --model needed",
                      "what a scene can do without is known of the built-in kernels alone", "--model full");
  std::iota(ranks_by_id_.begin(), ranks_by_id_.end(), 0u);
  std::ranges::sort(ranks_by_id_, {}, [this](std::uint32_t rank) { return id_[rank]; });
  DeviceScene layout = lay_out(scene, variant);
  bytes_ = layout.bytes;
  contact_slots_ = layout.contact_slots;
  is_fp64_ = layout.is_fp64;
  listed_way_ = listed_share * layout.skin;
  if (!layout.features.model(FeatureId::rotation))
    for (const Vector3d& spin : scene.particles.angular_velocity)
      constant_spin_.push_back(is_fp64_ ? spin : Vector3d(spin.cast<float>().cast<double>()));
  fixed_point_ = layout.fixed_point;
  half_history_ = layout.half_history;
  plan_ = make_step_plan(scene, variant, layout, KernelSources(options.kernel_folder));
  device_->build(plan_.units);
  for (std::size_t k = 0; k < n_device_arrays; ++k) {
    const auto array = static_cast<DeviceArray>(k);
    if (bytes_[array] > 0) device_->allocate(array, bytes_[array]);
    if (!layout.contents[array].empty()) device_->write(array, layout.contents[array]);
  }
  make_map();
  run(plan_.forces);
  check();
}

// Before any list is used: one that misses a contact is impossible.
bool DeviceSimulation::map_is_outdated() {
  if (plan_.check_map.empty()) return true;
  run(plan_.check_map);
  return download<std::uint32_t>(DeviceArray::lists_outdated)[0] != 0;
}

void DeviceSimulation::make_map() {
  run(maps_made_ % plan_.maps_between_moves == 0 ? plan_.map : plan_.map_in_place);
  ++maps_made_;
}

void DeviceSimulation::run(const std::vector<PlanEntry>& entries) {
  for (const PlanEntry& entry : entries) {
    if (const auto* swap = std::get_if<ArraySwap>(&entry)) {
      device_->swap(swap->first, swap->second);
    } else {
      device_->launch(std::get<KernelLaunch>(entry));
    }
  }
}

void DeviceSimulation::check() const {
  const std::vector<std::uint32_t> status = download<std::uint32_t>(DeviceArray::status);
  for (const StatusMessage& message : status_messages) {
    const std::uint32_t rank = status[message.word];
    if (rank == NO_PARTICLE) continue;
    throw SimulationError(
        fmt::format("step {}: particle {} {}", status[STATUS_STEPS], id_[rank], message.text));
  }
}

void DeviceSimulation::step(std::uint64_t n) {
  for (std::uint64_t k = 0; k < n; ++k) {
    run(plan_.integrate);
    kept_lists_ = !map_is_outdated();
    if (kept_lists_)
      run(plan_.keep_map);
    else
      make_map();
    run(plan_.forces);
    ++steps_done_;
    if ((k + 1) % steps_between_checks == 0 || k + 1 == n) {
      device_->finish();
      check();
    }
  }
}

template <class T>
std::vector<T> DeviceSimulation::download(DeviceArray array) const {
  std::vector<T> values(bytes_[array] / sizeof(T));
  if (!values.empty()) device_->read(array, std::as_writable_bytes(std::span(values)));
  return values;
}

std::vector<double> DeviceSimulation::download_reals(DeviceArray array) const {
  if (is_fp64_) return download<double>(array);
  const std::vector<float> values = download<float>(array);
  return {values.begin(), values.end()};
}

std::vector<double> DeviceSimulation::download_places() const {
  if (!fixed_point_) return download_reals(DeviceArray::position_radius);
  std::vector<double> lengths;
  for (const std::int64_t units : download<std::int64_t>(DeviceArray::position_radius))
    lengths.push_back(fixed_point_->length(units));
  return lengths;
}

std::vector<double> DeviceSimulation::download_displacements_before() const {
  using enum DeviceArray;
  if (!half_history_) return download_reals(history_displacements_before);
  return half_history_->lengths(download<std::uint16_t>(history_displacements_before));
}

std::vector<std::uint32_t> DeviceSimulation::places_by_id() const {
  const std::vector<std::uint32_t> rank_material = download<std::uint32_t>(DeviceArray::rank_material);
  std::vector<std::uint32_t> place_of_rank(id_.size());
  const std::size_t stride = rank_material.size() / id_.size();
  for (std::uint32_t place = 0; place < id_.size(); ++place)
    place_of_rank[rank_material[stride * place]] = place;
  std::vector<std::uint32_t> places;
  places.reserve(id_.size());
  for (std::uint32_t rank : ranks_by_id_) places.push_back(place_of_rank[rank]);
  return places;
}

ContactHistory DeviceSimulation::history_before(const std::vector<std::uint32_t>& places) const {
  ContactHistory history;
  if (contact_slots_ == 0) return history;
  const auto counts = download<std::uint32_t>(DeviceArray::contact_counts_before);
  const auto partners = download<std::uint32_t>(DeviceArray::history_partners_before);
  const auto displacements = download_displacements_before();
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t place = places[k];
    const std::size_t first = history.size();
    for (std::size_t slot = 0; slot < counts[2 * place] + counts[2 * place + 1]; ++slot) {
      const std::size_t index = place * contact_slots_ + slot;
      const std::uint32_t partner = partners[index];
      const bool is_wall = (partner & WALL_PARTNER_BIT) != 0;
      history.push_back(
          {id_[ranks_by_id_[k]], is_wall ? partner : id_[partner], vector_at(displacements, index, 3)});
    }
    std::sort(history.begin() + static_cast<std::ptrdiff_t>(first), history.end(),
              [](const ContactRecord& a, const ContactRecord& b) { return a.partner_id < b.partner_id; });
  }
  return history;
}

ParticleState DeviceSimulation::state() const {
  check();
  const std::vector<std::uint32_t> places = places_by_id();
  const std::vector<double> position = download_places();
  const std::vector<double> velocity = download_reals(DeviceArray::velocity_mass);
  const std::vector<double> angular_velocity = download_reals(DeviceArray::angular_velocity);
  ParticleState state;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::uint32_t rank = ranks_by_id_[k];
    state.id.push_back(id_[rank]);
    state.material.push_back(material_[rank]);
    // As the device holds them, like all else of the state: forces are a function of what is in it.
    state.radius.push_back(position[4 * places[k] + 3]);
    state.mass.push_back(velocity[4 * places[k] + 3]);
    state.position.push_back(vector_at(position, places[k], 4));
    state.velocity.push_back(vector_at(velocity, places[k], 4));
    state.angular_velocity.push_back(angular_velocity.empty() ? constant_spin_[rank]
                                                              : vector_at(angular_velocity, places[k], 4));
  }
  state.contact_history = history_before(places);
  return state;
}

ForceState DeviceSimulation::forces() const {
  check();
  const std::vector<double> force = download_reals(DeviceArray::force);
  const std::vector<double> torque = download_reals(DeviceArray::torque);
  ForceState forces;
  for (std::uint32_t place : places_by_id()) {
    forces.force.push_back(vector_at(force, place, 4));
    forces.torque.push_back(torque.empty() ? Vector3d::Zero() : vector_at(torque, place, 4));
  }
  return forces;
}

std::uint64_t DeviceSimulation::contact_count() const {
  check();
  const std::vector<std::uint32_t> counts = download<std::uint32_t>(DeviceArray::contact_counts);
  std::uint64_t between_particles = 0, with_walls = 0;
  for (std::size_t k = 0; k < counts.size(); k += 2) {
    between_particles += counts[k];
    with_walls += counts[k + 1];
  }
  return between_particles / 2 + with_walls;
}

}  // namespace warpgrain
