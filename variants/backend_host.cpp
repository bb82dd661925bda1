#include "variants/backend_host.hpp"

#include <chrono>

#include "core/reference_solver.hpp"
#include "variants/contact_laws.hpp"
#include "variants/device_scene.hpp"
#include "variants/precisions.hpp"

namespace warpgrain {
namespace {

// The C++ reference in the variant's precision. Of the contact law it knows the model: search, order and the
// way the law is written are a device's matters.
template <class Real>
class HostSimulation : public Simulation {
 public:
  HostSimulation(const Scene& scene, const BackendOptions& options)
      : solver_(scene, {.threads = options.threads, .contact_slots = contact_slots_for(scene.particles)}) {}

  void step(std::uint64_t n) override {
    const auto begin = std::chrono::steady_clock::now();
    solver_.step(n);
    timing_.calls += n;
    timing_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  ParticleState state() const override { return solver_.state(); }
  ForceState forces() const override { return solver_.forces(); }
  std::uint64_t contact_count() const override { return solver_.contact_count(); }
  std::uint64_t steps_done() const override { return solver_.steps_done(); }
  std::vector<KernelTiming> timings() const override { return {timing_}; }
  std::string device() const override { return "C++ reference"; }

 private:
  ReferenceSolver<Real> solver_;
  KernelTiming timing_{"step", 0, 0};
};

std::string lacks() { return {}; }

std::unique_ptr<Simulation> create(const Scene& scene, const Variant& variant,
                                   const BackendOptions& options) {
  Scene modelled = scene;
  modelled.model.contact = contact_law(variant).model;
  // The reference has two arithmetics; double stands in for places finer than float's.
  const Precision& precision = precision_of(variant);
  if (precision.is_fp64 || precision.has_fixed_places)
    return std::make_unique<HostSimulation<double>>(modelled, options);
  return std::make_unique<HostSimulation<float>>(modelled, options);
}

}  // namespace

const Backend host_backend{"host", "the C++ reference on the CPU", lacks, create};

}  // namespace warpgrain
