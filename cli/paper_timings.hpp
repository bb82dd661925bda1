#pragma once
// How fast both of the paper's models run, here and in documents of runs.

#include <cstdint>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "core/scene.hpp"
#include "reports/paper_rows.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

// The paper's kernels compute all of the model, whatever the scene.
Variant paper_variant(bool practical);

// On this machine, at this state, over so many steps: both models on OpenCL, the practical one in C++ on one
// core, the simple one with CUDA where there is that back end and a device.
std::vector<reports::PaperTiming> timings_here(const Scene& scene, const BackendOptions& options,
                                               std::uint64_t steps, Progress& progress);

// Of what `run --json` wrote. Throws InputError for a run without steps.
reports::PaperTiming timing_from(const std::string& file);

}  // namespace warpgrain::cli
