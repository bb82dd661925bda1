#pragma once
// The key "bed" of a report.

#include <nlohmann/json_fwd.hpp>

#include "core/json_reader.hpp"
#include "reports/bed.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json to_json(const Bed& bed);
// Throws InputError where the lists are not of one length.
Bed bed_from(const JsonReader& place);

}  // namespace warpgrain::reports
