#pragma once
// Another order of a launch's threads, from their kept traces.

#include <cstdint>
#include <vector>

#include "profiler/thread_key.hpp"
#include "profiler/thread_order.hpp"
#include "profiler/trace_store.hpp"

namespace warpgrain::profiler {

// The thread that comes to each place, [n_threads]. Threads move within stretches of `stretch` of them;
// places of threads that do not exist keep those. `key` is what `sorted` sorts by. The same seed gives the
// same order everywhere.
std::vector<std::uint64_t> permuted_threads(const ThreadOrder& order, const ThreadKey* key,
                                            const TraceStore& traces, std::uint64_t stretch);

}  // namespace warpgrain::profiler
