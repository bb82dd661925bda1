#include "reports/paper_rows.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "analysis/least_time.hpp"
#include "analysis/paper_bounds.hpp"
#include "analysis/sfu_cost.hpp"

namespace warpgrain::reports {
namespace {

using Row = PaperReport::Row;

constexpr const char* table_3 = "Table 3";
constexpr const char* eq_13 = "eq. (13), candidates";
constexpr const char* bounds = "section 6, bounds";
constexpr const char* product = "section 6, factors multiplied";
constexpr const char* machines = "least time of a step";

double least_step_time(const PaperStep& step, const Machine& machine) {
  double seconds = 0;
  for (const profiler::LaunchCounters& launch : step.launches)
    seconds += least_time(launch.totals, step.warp_width, machine).seconds();
  return seconds;
}

std::vector<PaperReport::Measured> measured(const PaperFacts& facts, bool practical,
                                            std::string_view backend) {
  std::vector<PaperReport::Measured> values;
  for (const PaperTiming& timing : facts.timings)
    if (timing.practical == practical && timing.backend == backend)
      values.push_back({timing.particle_steps_per_second, timing.on});
  return values;
}

// Ratios of the first value of each: what was timed on this machine, where it was.
std::vector<PaperReport::Measured> ratio(const std::vector<PaperReport::Measured>& a,
                                         const std::vector<PaperReport::Measured>& b) {
  if (a.empty() || b.empty()) return {};
  return {{a.front().value / b.front().value,
           a.front().on == b.front().on ? a.front().on : fmt::format("{} / {}", a.front().on, b.front().on)}};
}

void add_throughputs(std::vector<Row>& rows, const PaperFacts& facts) {
  const auto n = static_cast<double>(facts.particles);
  const double simple = n / least_step_time(facts.simple, facts.paper_machine);
  const double practical = n / least_step_time(facts.practical, facts.paper_machine);
  const auto simple_cuda = measured(facts, false, "cuda"), simple_opencl = measured(facts, false, "opencl");
  const auto practical_opencl = measured(facts, true, "opencl"),
             practical_cpp = measured(facts, true, "host");
  const char* unit = "particles/s";
  rows.push_back({table_3, "simple model, CUDA", unit, paper::simple_cuda, {}, simple, simple_cuda, ""});
  rows.push_back(
      {table_3, "simple model, OpenCL", unit, paper::simple_opencl, {}, simple, simple_opencl, ""});
  rows.push_back(
      {table_3,
       "practical model, OpenCL",
       unit,
       paper::practical_opencl,
       {},
       practical,
       practical_opencl,
       fmt::format("simulated: at most, on {}, if nothing but issuing and special functions took time",
                   facts.paper_machine.name)});
  rows.push_back(
      {table_3, "practical model, C++ on one core", unit, paper::practical_cpp, {}, {}, practical_cpp, ""});
  rows.push_back({table_3,
                  "simple / practical, OpenCL",
                  "",
                  paper::simple_opencl / paper::practical_opencl,
                  {},
                  simple / practical,
                  ratio(simple_opencl, practical_opencl),
                  ""});
  rows.push_back({table_3,
                  "practical, OpenCL / C++",
                  "",
                  paper::practical_opencl / paper::practical_cpp,
                  {},
                  {},
                  ratio(practical_opencl, practical_cpp),
                  ""});
  rows.push_back({table_3,
                  "simple, OpenCL / CUDA",
                  "",
                  paper::simple_opencl / paper::simple_cuda,
                  {},
                  {},
                  ratio(simple_opencl, simple_cuda),
                  ""});
}

void add_candidates(std::vector<Row>& rows, const PaperReport& report) {
  std::uint32_t most_candidates = 0, most_contacts = 0;
  for (const StateSample& sample : report.samples) {
    most_candidates = std::max(most_candidates, sample.most_candidates);
    most_contacts = std::max(most_contacts, sample.most_contacts);
  }
  const StateSample& last = report.samples.back();
  rows.push_back({eq_13,
                  "candidates a particle",
                  "",
                  paper::printed_candidates,
                  paper::candidates(),
                  last.mean_candidates,
                  {},
                  "the paper prints about 47; 27 sqrt(2) is 38.2. Simulated: mean over the last state"});
  rows.push_back({eq_13,
                  "candidates, worst case",
                  "",
                  {},
                  paper::candidates(),
                  most_candidates,
                  {},
                  "simulated: most of any particle in any sampled state"});
  rows.push_back({eq_13,
                  "contacts, worst case",
                  "",
                  paper::most_contacts,
                  paper::most_contacts,
                  most_contacts,
                  {},
                  "soft spheres of one size; simulated: most of any particle in any sampled state"});
  rows.push_back({eq_13,
                  "share of candidates that touch",
                  "",
                  paper::printed_contact_share,
                  paper::contact_share(),
                  last.mean_candidates > 0 ? last.mean_contacts / last.mean_candidates : 0,
                  {},
                  "paper and model: at most; simulated: mean over the last state"});
}

double special_functions(const profiler::Totals& totals) {
  return static_cast<double>(
      totals.instruction_mix[static_cast<std::size_t>(profiler::InstructionClass::special_function)].thread);
}

void add_bounds(std::vector<Row>& rows, const PaperReport& report, const PaperFacts& facts) {
  const profiler::LaunchCounters& forces = facts.practical.forces();
  const std::uint32_t width = facts.practical.warp_width;
  const double efficiency = forces.totals.simt_efficiency(width);
  const double contacts = report.samples.back().mean_contacts * static_cast<double>(facts.particles);
  rows.push_back({bounds,
                  "peak of the GPU / of a core",
                  "",
                  paper::printed_peak_ratio,
                  paper::peak_ratio(),
                  {},
                  {},
                  ""});
  rows.push_back(
      {bounds,
       "loss to contacts that are not there",
       "",
       1 / paper::printed_contact_share,
       1 / paper::contact_share(),
       1 / efficiency,
       {},
       "simulated: lane slots issued over lane slots used, of the force kernel, whatever parted the lanes"});
  rows.push_back({bounds,
                  "the same, worst case",
                  "",
                  paper::printed_candidates,
                  paper::candidates(),
                  {},
                  {},
                  "one lane of a warp works at a time, for every candidate"});
  rows.push_back(
      {bounds,
       "speed-up of a warp, 32 / M",
       "",
       {},
       paper::speed_up_bound(1 / efficiency),
       forces.totals.active_lanes(),
       {},
       fmt::format("M = {:.3g} instructions at once, from the simulated efficiency; simulated: active "
                   "lanes an instruction",
                   1 / efficiency)});
  const auto widest = std::ranges::max_element(report.paths, {}, &PaperReport::Paths::branches);
  if (widest != report.paths.end())
    rows.push_back(
        {bounds,
         "paths through N branches, 2^N",
         "",
         {},
         paper::paths_bound(widest->branches),
         static_cast<double>(widest->paths),
         {},
         fmt::format("N = {} conditional branches of the body at line {} of the force kernel; simulated: "
                     "different paths that lanes took",
                     widest->branches, widest->line)});
  const SfuCost sfu = sfu_cost(forces.totals, width, facts.paper_machine);
  rows.push_back(
      {bounds, "turns of a warp on 4 SFUs", "", paper::sfu_bound(), sfu.serialisation, {}, {}, ""});
  rows.push_back(
      {bounds,
       "SFU time / issue time",
       "",
       {},
       {},
       sfu.share(),
       {},
       fmt::format("of the force kernel on {}; above 1 the SFUs are the limit", facts.paper_machine.name)});
  if (contacts > 0)
    rows.push_back({bounds,
                    "SFU calls a contact",
                    "",
                    paper::printed_sfu_calls,
                    {},
                    special_functions(forces.totals) / contacts,
                    {},
                    "simulated: special functions that lanes ran in the force kernel, over contacts seen "
                    "from both sides"});
  rows.push_back(
      {product,
       "contacts x SFU",
       "",
       paper::sfu_bound() / paper::printed_contact_share,
       paper::sfu_bound() / paper::contact_share(),
       std::max(1.0, sfu.share()) / efficiency,
       {},
       "paper and model: as if independent and always at their bounds; simulated: of the whole force kernel, "
       "loss of lanes times what SFUs add to issuing. They overlap: lanes that wait need no SFU"});
}

void add_machines(std::vector<Row>& rows, const PaperFacts& facts) {
  std::vector<const Machine*> all{&facts.paper_machine};
  if (facts.machine && facts.machine->name != facts.paper_machine.name) all.push_back(&*facts.machine);
  for (const Machine* machine : all)
    for (const PaperStep* step : {&facts.simple, &facts.practical})
      rows.push_back(
          {machines,
           fmt::format("{} model on {}", step == &facts.simple ? "simple" : "practical", machine->name),
           "ms",
           {},
           {},
           1e3 * least_step_time(*step, *machine),
           {},
           ""});
}

}  // namespace

const profiler::LaunchCounters& PaperStep::forces() const {
  return *std::ranges::max_element(launches, {},
                                   [](const auto& launch) { return launch.totals.warp_instructions; });
}

void add_paper_rows(PaperReport& report, const PaperFacts& facts) {
  add_throughputs(report.rows, facts);
  add_candidates(report.rows, report);
  add_bounds(report.rows, report, facts);
  add_machines(report.rows, facts);
}

}  // namespace warpgrain::reports
