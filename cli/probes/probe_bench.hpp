#pragma once
// Where probes run: one variant on one back end, watched as every run is.

#include <cstdint>
#include <functional>
#include <string>

#include "core/model.hpp"
#include "core/scene.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

class ProbeBench {
 public:
  // `rest_steps`: how long probes of rest may last.
  ProbeBench(const Backend& backend, const Variant& variant, BackendOptions options,
             std::uint64_t rest_steps);

  const Backend& backend() const { return *backend_; }
  const Variant& variant() const { return variant_; }
  ContactModel model() const;
  std::uint64_t rest_steps() const { return rest_steps_; }

  // The state after `steps` steps, or as soon as `is_done`. A monitor looks at the start, after every
  // `look_every` steps and at the end, and `is_done` is asked then. Throws InputError with the one line that
  // a user would see where the scene cannot be carried.
  using IsDone = std::function<bool(const ParticleState&)>;
  ParticleState run(const Scene& scene, std::uint64_t steps, std::uint64_t look_every = 16,
                    const IsDone& is_done = {}) const;
  // Forces at the scene's state, which the monitor has seen.
  ForceState forces(const Scene& scene) const;

 private:
  // With the model that the variant computes, whatever the scene's is.
  Scene modelled(const Scene& scene) const;

  const Backend* backend_;
  Variant variant_;
  BackendOptions options_;
  std::uint64_t rest_steps_;
};

// The double reference of the same model, on one thread.
ProbeBench reference_bench(const ProbeBench& bench);

}  // namespace warpgrain::cli
