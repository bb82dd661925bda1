#pragma once
// Reading and writing of modelled parts. Seen only by the sources of formats: the JSON library is slow to
// compile.

#include <nlohmann/json.hpp>
#include <string>

#include "core/json_reader.hpp"
#include "reports/modelled_parts.hpp"

namespace warpgrain::reports {

void add_modelled_parts(nlohmann::ordered_json& document, const ModelledParts& parts);
ModelledParts modelled_parts_from(const JsonReader& document);

// The name of the variant that a document says, which is the name of today. Documents made before there was
// the axis `model` have no `features`: what they ran is what is now /model=full. Not of measurements, whose
// names were true before they had features.
std::string variant_from(const JsonReader& document);
// The same for a case of a sweep, which names the value of each axis.
std::string variant_of_case_from(const JsonReader& sweep_case);

}  // namespace warpgrain::reports
