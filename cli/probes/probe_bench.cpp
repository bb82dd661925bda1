#include "cli/probes/probe_bench.hpp"

#include <algorithm>
#include <utility>

#include "core/run_monitor.hpp"
#include "variants/contact_laws.hpp"

namespace warpgrain::cli {

ProbeBench::ProbeBench(const Backend& backend, const Variant& variant, BackendOptions options,
                       std::uint64_t rest_steps)
    : backend_(&backend), variant_(variant), options_(std::move(options)), rest_steps_(rest_steps) {
  options_.kernel_times = BackendOptions::KernelTimes::none;
  options_.threads = 1;  // a handful of particles
}

ContactModel ProbeBench::model() const { return contact_law(variant_).model; }

Scene ProbeBench::modelled(const Scene& scene) const {
  Scene result = scene;
  result.model.contact = model();
  return result;
}

ParticleState ProbeBench::run(const Scene& scene, std::uint64_t steps, std::uint64_t look_every,
                              const IsDone& is_done) const {
  RunMonitor monitor(modelled(scene));
  monitor.look(0, scene.particles);
  const auto simulation = backend_->create(scene, variant_, options_);
  ParticleState state = simulation->state();
  while (simulation->steps_done() < steps && !(is_done && is_done(state))) {
    simulation->step(std::min(look_every, steps - simulation->steps_done()));
    state = simulation->state();
    monitor.look(simulation->steps_done(), state);
  }
  return state;
}

ForceState ProbeBench::forces(const Scene& scene) const {
  RunMonitor(modelled(scene)).look(0, scene.particles);
  return backend_->create(scene, variant_, options_)->forces();
}

ProbeBench reference_bench(const ProbeBench& bench) {
  Variant variant;
  variant.set("contact", bench.variant().value(AxisId::contact));
  variant.set("precision", "fp64");
  return {backend("host"), variant, {}, bench.rest_steps()};
}

}  // namespace warpgrain::cli
