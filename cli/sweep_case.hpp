#pragma once
// One case of a sweep: a variant timed, checked and profiled at the sweep's common state.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/profile_options.hpp"
#include "core/reference_forces.hpp"
#include "core/scene.hpp"
#include "reports/sweep_index.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

// What all cases share.
struct SweepSetting {
  Scene scene;  // particles at the common state
  // States on the way there, each sampled in every case.
  struct Passed {
    std::uint64_t step = 0;
    ParticleState particles;
  };
  std::vector<Passed> passed;
  std::uint64_t at_step = 0;
  std::uint64_t timed_steps = 0;
  std::uint64_t bed = 0;  // particles that reports draw
  BackendOptions backend;
  profiler::ProfileOptions profile;
  std::optional<Machine> machine;
  std::filesystem::path folder;
};

// Forces of the double reference at the common state, evaluated once for each contact model.
class ReferenceForces {
 public:
  explicit ReferenceForces(const SweepSetting& setting) : setting_(setting) {}
  const ForceState& of(ContactModel model);

 private:
  const SweepSetting& setting_;
  std::map<ContactModel, ForceState> forces_;
};

// The error of the variant's forces against the double reference on the host and on the OpenCL device, and
// the device's seconds a step.
std::vector<reports::BackendReading> time_and_check(const SweepSetting& setting, const Variant& variant,
                                                    ReferenceForces& reference);

// Profiles one time step and writes its report, as JSON and as a page, and its PTX into the folder; returns
// the file's name, the headline numbers and the samples.
struct ProfiledCase {
  std::string report_file;
  reports::Headline headline;
  std::vector<reports::SweepCase::Sample> samples;
  std::optional<double> device_bytes_per_particle;
};
ProfiledCase profile_case(const SweepSetting& setting, const Variant& variant);

}  // namespace warpgrain::cli
