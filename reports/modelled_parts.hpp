#pragma once
// Which parts of the model a document's kernels compute, and what it saves to leave out the others. The same
// keys in "warpgrain.report/1", "warpgrain.run/1" and "warpgrain.measured/1": `features`,
// `device_bytes_per_particle`, `against_full`.

#include <optional>
#include <string>
#include <vector>

namespace warpgrain::reports {

struct FeatureRow {
  std::string name;       // rotation, friction, ...
  bool needed = false;    // by the scene
  bool modelled = false;  // by the kernels
  std::string why;        // needed or not
};

// The same quantity with the kernels of the document and with the full model.
struct Saving {
  std::string quantity;
  double value = 0, full = 0;
};

struct ModelledParts {
  std::vector<FeatureRow> features;  // empty in documents that say nothing of it
  std::optional<double> device_bytes_per_particle;
  std::vector<Saving> against_full;  // empty unless it was asked for
  // Of a run, then: how far apart a particle is in the end with and without the full model [m].
  std::optional<double> position_difference;
};

// For people: what is left out and why, then the savings. Empty for documents that say nothing of it.
std::string text_modelled_parts(const ModelledParts& parts);

}  // namespace warpgrain::reports
