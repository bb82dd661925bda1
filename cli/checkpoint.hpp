#pragma once
// What `--checkpoint DIR` keeps of a run that ended or was interrupted, and `--resume` goes on from:
// state.csv and contacts.csv; of `run`, run.json, too, the document of the run so far.

#include <filesystem>

#include "core/scene.hpp"
#include "reports/run_report.hpp"

namespace warpgrain::cli {

// Into a folder that is there. Throws InputError when a file cannot be written.
void write_checkpoint(const std::filesystem::path& folder, const reports::RunReport& report,
                      const ParticleState& state);

// The particles alone.
void write_particles(const std::filesystem::path& folder, const ParticleState& state);
// Throws InputError where they are damaged, or not the scene's.
void read_particles(const std::filesystem::path& folder, Scene& scene);

// Puts the particles of the checkpoint into `scene` and returns its document. Throws InputError where the
// checkpoint is damaged, or of another scene, variant, back end, time step or number of particles than
// `begun` and `scene` say.
reports::RunReport read_checkpoint(const std::filesystem::path& folder, const reports::RunReport& begun,
                                   Scene& scene);

}  // namespace warpgrain::cli
