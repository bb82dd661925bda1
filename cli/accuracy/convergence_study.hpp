#pragma once
// What smaller steps make of an oblique impact under each choice of what happens to the tangential
// displacement of a contact that slips.

#include <vector>

#include "reports/study_report.hpp"

namespace warpgrain::cli {

// Of the double reference on the scene impact_4_alumina: one table an angle and restitution.
std::vector<reports::StudyReport::Table> convergence_tables();

}  // namespace warpgrain::cli
