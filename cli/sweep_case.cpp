#include "cli/sweep_case.hpp"

#include <string_view>
#include <vector>

#include "analysis/force_error.hpp"
#include "cli/bed.hpp"
#include "cli/list_making_of.hpp"
#include "cli/modelled_parts.hpp"
#include "cli/output.hpp"
#include "cli/state_samples.hpp"
#include "cli/step_timing.hpp"
#include "cli/sweep_plan.hpp"
#include "core/file_io.hpp"
#include "reports/html/report_page.hpp"
#include "reports/ptx_files.hpp"
#include "reports/report_json.hpp"
#include "variants/contact_laws.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

const ForceState& ReferenceForces::of(ContactModel model) {
  const auto known = forces_.find(model);
  if (known != forces_.end()) return known->second;
  Scene scene = setting_.scene;
  scene.model.contact = model;
  return forces_[model] = evaluate_forces(scene, scene.particles, scene.time_step).forces;
}

namespace {

reports::BackendReading check_forces(std::string_view backend_name, const Simulation& simulation,
                                     const ForceState& expected) {
  reports::BackendReading reading;
  reading.backend = backend_name;
  reading.device = simulation.device();
  const ForceError error = force_error(simulation.state(), simulation.forces(), expected);
  reading.force_error = {{error.force.maximum, error.force.root_mean_square}};
  return reading;
}

}  // namespace

std::vector<reports::BackendReading> time_and_check(const SweepSetting& setting, const Variant& variant,
                                                    ReferenceForces& reference) {
  const ForceState& expected = reference.of(contact_law(variant).model);
  std::vector<reports::BackendReading> readings;
  for (std::string_view name : {"host", "opencl"}) {
    const auto simulation = backend(name).create(setting.scene, variant, setting.backend);
    readings.push_back(check_forces(name, *simulation, expected));
    if (name != "opencl" || setting.timed_steps == 0) continue;
    readings.back().steps = setting.timed_steps;
    readings.back().seconds_per_step = median_seconds_per_step(*simulation, setting.timed_steps);
  }
  return readings;
}

ProfiledCase profile_case(const SweepSetting& setting, const Variant& variant) {
  ProfiledState left;
  const std::vector<profiler::LaunchProfile> launches =
      profile_step(setting.scene, variant, setting.profile, setting.backend, {}, &left);
  reports::Report report = reports::make_report(launches, command_line());
  report.machine = setting.machine;
  report.list_making = list_making_of(launches, left, setting.machine);
  report.scene = setting.scene.name;
  report.variant = variant.name();
  report.model = modelled_parts(setting.scene, variant, "simt");
  report.bed = bed_of(setting.scene, variant, launches, left, setting.bed);
  report.particles = setting.scene.particles.size();
  report.step = setting.at_step;
  report.seed = setting.scene.seed;
  ProfiledCase result{file_stem(variant) + ".report.json",
                      reports::headline_of(report),
                      {},
                      report.model.device_bytes_per_particle};
  for (const SweepSetting::Passed& passed : setting.passed) {
    Scene scene = setting.scene;
    scene.particles = passed.particles;
    report.samples.push_back(sample_state(scene, passed.step, variant, setting.profile, setting.backend));
    const reports::StateSample& sample = report.samples.back();
    result.samples.push_back({sample.step, sample.time, sample.simt_efficiency()});
  }
  reports::keep_ptx(report, launches, setting.folder / result.report_file);
  write_file_atomically(setting.folder / result.report_file, reports::report_json(report));
  const auto page = std::filesystem::path(result.report_file).replace_extension(".html");
  write_file_atomically(setting.folder / page, reports::report_page(report));
  return result;
}

}  // namespace warpgrain::cli
