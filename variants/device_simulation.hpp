#pragma once
// A Simulation over any device that runs the step plan.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "variants/backend.hpp"
#include "variants/compute_device.hpp"

namespace warpgrain {

class DeviceSimulation : public Simulation {
 public:
  // Evaluates the forces at the scene's positions.
  DeviceSimulation(const Scene& scene, const Variant& variant, const BackendOptions& options,
                   std::unique_ptr<ComputeDevice> device);

  void step(std::uint64_t n) override;
  ParticleState state() const override;
  ForceState forces() const override;
  std::uint64_t contact_count() const override;
  std::uint64_t steps_done() const override { return steps_done_; }
  std::vector<KernelTiming> timings() const override { return device_->timings(); }
  std::string device() const override { return device_->name(); }
  std::string driver() const override { return device_->driver(); }

  // Whether the last step used lists that an earlier one had made.
  bool kept_lists() const { return kept_lists_; }
  // How far a particle may move until lists are made anew [m].
  double listed_way() const { return listed_way_; }
  // Makes map and lists anew, as a step does whose lists are outdated. No step follows: there are no forces.
  void renew_lists() { run(plan_.map); }

  // Where the k-th particle by id stands in the device's arrays now, [n_particles].
  std::vector<std::uint32_t> places_by_id() const;

 private:
  void run(const std::vector<PlanEntry>& entries);
  bool map_is_outdated();
  void make_map();
  // Throws SimulationError when a kernel has reported an error.
  void check() const;
  template <class T>
  std::vector<T> download(DeviceArray array) const;
  std::vector<double> download_reals(DeviceArray array) const;
  std::vector<double> download_places() const;  // x, y, z, radius [m] a particle
  std::vector<double> download_displacements_before() const;
  ContactHistory history_before(const std::vector<std::uint32_t>& places) const;

  std::unique_ptr<ComputeDevice> device_;
  StepPlan plan_;
  // By rank, [n_particles]: what does not change, as the scene gave it.
  std::vector<std::uint32_t> id_, material_;
  std::vector<std::uint32_t> ranks_by_id_;
  // By rank, as a device would hold them: of scenes without rotation, where spins never change.
  std::vector<Vector3d> constant_spin_;
  PerArray<std::size_t> bytes_;
  std::uint32_t contact_slots_ = 0;
  bool is_fp64_ = false;
  std::optional<FixedPoint> fixed_point_;
  std::optional<HalfHistory> half_history_;
  std::uint64_t steps_done_ = 0, maps_made_ = 0;
  bool kept_lists_ = false;
  double listed_way_ = 0;
};

}  // namespace warpgrain
