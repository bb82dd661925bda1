#pragma once
// A sweep's table for other programs and for papers.

#include <string>

#include "reports/sweep_index.hpp"

namespace warpgrain::reports {

// Comma-separated values, RFC 4180: a header, and a row a case: variant, status, every axis, and the columns
// of the table as full numbers; empty where a case has none.
std::string csv_sweep(const SweepIndex& index);

// A Markdown table with the columns of the terminal's, and its notes below.
std::string markdown_sweep(const SweepIndex& index);

}  // namespace warpgrain::reports
