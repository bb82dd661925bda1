#pragma once
// The words of --what-if: axes, of which all combinations are asked.

#include <string>
#include <vector>

#include "profiler/merge_policy.hpp"
#include "profiler/what_if.hpp"

namespace warpgrain::cli {

// Each word is NAME=VALUE,VALUE...: width=8,16 policy=ipdom,min_pc order=launched,shuffled:7,sorted:LABEL
// pool=64,128. An axis that no word names has the run's own value; one that several words name has all their
// values. Pools are asked beside the policies: of each width and order, whatever the policies; without width
// or policy or order they are all that is asked. Throws InputError naming the word.
std::vector<profiler::WhatIf> what_if_questions(const std::vector<std::string>& words,
                                                std::uint32_t run_width, profiler::MergePolicy run_policy);

}  // namespace warpgrain::cli
