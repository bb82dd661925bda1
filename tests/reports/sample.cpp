#include "sample.hpp"

namespace warpgrain::reports::sample {
namespace {

constexpr const char* source_text =
    "#line 1 \"contact/law.cl\"\n"
    "void law(int i) {\n"
    "  if (i < 2 && i > -1)  // branch: contact test\n"
    "    force[i] = sqrt(overlap) /* <&> */;\n"
    "}\n";

}  // namespace

profiler::Totals totals(std::uint64_t full, std::uint64_t half) {
  profiler::Totals t;
  t.warp_instructions = full + half;
  t.thread_instructions = 4 * full + 2 * half;
  t.lane_histogram = {0, 0, half, 0, full};
  t.sfu_instructions = half;
  t.instruction_mix[static_cast<std::size_t>(profiler::InstructionClass::fp32)] = {full, 4 * full};
  t.instruction_mix[static_cast<std::size_t>(profiler::InstructionClass::special_function)] = {half,
                                                                                               2 * half};
  t.global_load = {.requests = full, .sectors = 3 * full, .lines = 2 * full, .useful_bytes = 16 * full};
  t.shared_store = {.requests = half, .sectors = 0, .lines = 0, .useful_bytes = 8 * half};
  return t;
}

namespace {

profiler::Totals without_requests(profiler::Totals t) {
  t.global_load = t.shared_store = {};
  return t;
}

profiler::Totals of_a_pool(profiler::Totals t) {
  t.lane_histogram.clear();
  return without_requests(t);
}

}  // namespace

profiler::LaunchProfile launch(const std::string& kernel) {
  profiler::LaunchProfile profile;
  profiler::LaunchCounters& c = profile.counters;
  c.kernel = kernel;
  c.shape = {.global_size = {8, 1, 1}, .local_size = {8, 1, 1}};
  c.shared_bytes = 64;
  c.footprint = {20, 4, 16, 4, 2, 18};
  c.touched = {{4, (1u << 18) - 1}};
  c.warp_width = warp_width;
  c.policy = "loop_postdom";
  c.warps = 2;
  c.totals = totals(10, 6);
  c.totals.branches = 2;
  c.totals.divergent_branches = 1;
  c.lines = {{"contact/law.cl", 2, totals(10, 0)}, {"contact/law.cl", 3, totals(0, 6)}};
  c.lines[0].totals.branches = 2;
  c.lines[0].totals.divergent_branches = 1;
  c.blocks = {{.block = 0,
               .label = "entry",
               .instructions = 5,
               .executions = 2,
               .divergent = 1,
               .lane_histogram = {0, 0, 0, 0, 2},
               .file = ""},
              {.block = 1,
               .label = "then",
               .instructions = 3,
               .executions = 2,
               .divergent = 0,
               .lane_histogram = {0, 0, 2, 0, 0},
               .file = "contact/law.cl",
               .line = 3}};
  c.branches = {{.file = "contact/law.cl",
                 .line = 2,
                 .label = "contact test",
                 .block = 0,
                 .executions = 2,
                 .divergent = 1,
                 .lanes = 8,
                 .taken_lanes = 4,
                 .lane_slots_lost = 12}};
  const char* const remark = "the <kernel> has barriers";
  c.what_if = {
      {warp_width, "min_pc", "launched", 0, 2, totals(12, 2), true, ""},
      {warp_width, "ipdom", "sorted:contact test", 0, 2, without_requests(totals(13, 0)), false, remark},
      {warp_width, "", "launched", 64, 0, of_a_pool(totals(11, 0)), false, remark}};
  c.timelines = {{.warp = 1,
                  .chosen_as = {"median", "worst"},
                  .sums = {16, 52},
                  .executions = 5,  // two were cut off
                  .blocks = {0, 1, 1},
                  .lanes = {15, 9, 6}}};
  profile.source = source_text;
  profile.source_name = "step.cl";
  profile.ptx = "// " + kernel;
  profile.compiler = "clang version 15.0.6";
  profile.compile_command = "-cl-std=CL1.2";
  return profile;
}

std::vector<StateSample> state_samples() {
  return {{0, 0, 10, 1, 30, 3, {{"force", 1000, 0.4}, {"sort", 1, 0.9}}},
          {100, 0.1, 20, 4, 40, 7, {{"force", 2000, 0.3}}}};
}

ModelledParts modelled() {
  ModelledParts parts;
  parts.features = {{"friction", true, true, "tangential forces of some pair"},
                    {"gravity", false, false, "zero"},
                    {"radii", false, true, "all particles have one"}};
  parts.device_bytes_per_particle = 96.5;
  parts.against_full = {{"warp instructions a particle and step", 60, 80}};
  return parts;
}

Report report() {
  const std::vector launches{launch("sort"), launch("force"), launch("force")};
  Report r = make_report(launches, "warpgrain profile --scene <slit>");
  r.scene = "slit";
  r.variant = "branchy/cells/cell/fp32/default";
  r.model = modelled();
  r.particles = 16384;
  r.seed = 7;
  r.step = 4000;
  r.samples = state_samples();
  r.machine = load_machine("fermi_c2050");
  r.list_making = ListMaking{12, 1000, 24000, 3e-5};
  r.launches[0].ptx.file = "report.ptx";
  r.bed = Bed{.particles = 16384,
              .slab = "the 3 nearest to y = 0.5 m",
              .kernel = "force",
              .unit = 1e-4,
              .box = {{-50, -50, 0}, {50, 50, 100}},
              .x = {-40, 0, 40},
              .y = {0, 0, 0},
              .z = {10, 10, 50},
              .radius = {10},
              .contacts = {0, 1, 2},
              .candidates = {3, 4, 5},
              .warp = {0, 0, 1},
              .efficiency = {0.25, 0.25, 1}};
  return r;
}

RunReport run() {
  RunReport r;
  r.generator = this_generator();
  r.command_line = "warpgrain run --scene slit";
  r.scene = "slit";
  r.variant = "simple/cells/cell/fp32/default";
  r.model = modelled();
  r.model.position_difference = 1.5e-9;
  r.backend = "opencl";
  r.device = "pthread-device";
  r.particles = 1000;
  r.seed = 7;
  r.steps = 50;
  r.time_step = 1e-5;
  r.wall_seconds = 0.25;
  r.ended_by = RunEndReason::at_rest;
  r.kernels = {{"force", 50, 0.125}};
  r.energy = {{0, 0, 1, 2, 3, 4}, {50, 5e-4, 0.5, 0.25, -3, 0.1}};
  r.contacts = 17;
  return r;
}

MeasuredReport measured() {
  MeasuredReport m;
  m.generator = this_generator();
  m.command_line = "warpgrain measure --scene slit";
  m.backend = "cuda";
  m.device = {"NVIDIA H100", "sm_90", "580.1, CUDA 13.0"};
  m.scene = "slit";
  m.variant = "simple/cells/cell/fp32/default";
  m.model = modelled();
  m.particles = 1000;
  m.seed = 7;
  m.step = {16, {1e-3, 1.5e-3, 1.25e-3}};
  MeasuredReport::Kernel kernel;
  kernel.kernel = "force";
  kernel.launch_file = "force.sim";
  kernel.global_size = {1024, 1, 1};
  kernel.local_size = {128, 1, 1};
  kernel.calls = 2;
  kernel.seconds = {2e-4, 1e-4};
  kernel.code = {"ptxas release 13.0", "fnv1a64:0123456789abcdef", 40, 1024, 0};
  kernel.agreement = {{"force", 4096, 3, 1e-7}};
  kernel.counters = {{"sfu_instructions", 300}, {"warp_instructions", 12345}};
  m.kernels.push_back(kernel);
  return m;
}

SweepIndex sweep() {
  SweepIndex index;
  index.generator = this_generator();
  index.command_line = "warpgrain sweep --scene slit --out out";
  index.scene = "slit";
  index.particles = 16384;
  index.seed = 7;
  index.step = 4000;
  SweepCase done;
  done.variant = "branchy/cells/cell/fp32/default";
  done.axes = {{"contact", "branchy"}, {"search", "cells"}, {"order", "cell"}, {"model", "needed"}};
  done.report_file = "branchy_cells_cell_fp32_default.json";
  done.headline = headline_of(kernels_of(report()));
  done.device_bytes_per_particle = 96.5;
  done.backends = {
      {.backend = "opencl",
       .device = "pthread-device",
       .steps = 20,
       .seconds_per_step = 0.0123,
       .force_error = ForceErrorReading{1.5e-6, 2.5e-8}},
      {.backend = "simt", .device = "simulator", .steps = 1, .seconds_per_step = {}, .force_error = {}}};
  done.samples = {{0, 0, 0.5}, {4000, 0.04, 0.25}};
  SweepCase failed;
  failed.variant = "branchy/cells/unsorted/fp32/default";
  failed.axes = {{"contact", "branchy"}, {"search", "cells"}, {"order", "unsorted"}, {"model", "needed"}};
  failed.status = CaseStatus::failed;
  failed.message = "step 12: particle 7 left the domain";
  index.cases = {done, failed};
  return index;
}

}  // namespace warpgrain::reports::sample
