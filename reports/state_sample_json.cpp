#include "reports/state_sample_json.hpp"

#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const StateSample& sample) {
  nlohmann::ordered_json json{{"step", sample.step},
                              {"time", sample.time},
                              {"mean_candidates", sample.mean_candidates},
                              {"most_candidates", sample.most_candidates},
                              {"mean_contacts", sample.mean_contacts},
                              {"most_contacts", sample.most_contacts},
                              {"kernels", nlohmann::ordered_json::array()}};
  for (const StateSample::Kernel& kernel : sample.kernels)
    json["kernels"].push_back({{"kernel", kernel.kernel},
                               {"warp_instructions", kernel.warp_instructions},
                               {"simt_efficiency", kernel.simt_efficiency}});
  return json;
}

std::vector<StateSample> state_samples_from(const JsonReader& place) {
  std::vector<StateSample> samples;
  for (const JsonReader& element : place.elements()) {
    StateSample& sample = samples.emplace_back();
    sample.step = element.at("step").whole_number();
    sample.time = element.at("time").number();
    sample.mean_candidates = element.at("mean_candidates").number();
    sample.most_candidates = whole_number32(element.at("most_candidates"));
    sample.mean_contacts = element.at("mean_contacts").number();
    sample.most_contacts = whole_number32(element.at("most_contacts"));
    for (const JsonReader& kernel : element.at("kernels").elements())
      sample.kernels.push_back({kernel.at("kernel").string(), kernel.at("warp_instructions").whole_number(),
                                kernel.at("simt_efficiency").number()});
  }
  return samples;
}

}  // namespace warpgrain::reports
