#include "reports/metrics.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/error.hpp"

namespace warpgrain::reports {
namespace {

constexpr Metric table[] = {
    {"warp_instructions", "warp instructions", "instructions", "instructions issued, one a warp",
     "smsp__inst_executed.sum"},
    {"thread_instructions", "thread instructions", "instructions",
     "instructions issued, counted per active lane", "smsp__thread_inst_executed.sum"},
    {"thread_instructions_pred_on", "thread instructions, predicated on", "instructions",
     "of the thread instructions, those whose predicate was true; counted where machine code is replayed",
     "smsp__thread_inst_executed_pred_on.sum"},
    {"active_lanes", "active lanes", "lanes", "thread_instructions / warp_instructions",
     "smsp__thread_inst_executed_per_inst_executed.ratio"},
    {"simt_efficiency", "SIMT efficiency", "ratio", "active_lanes / warp_width", ""},
    {"lane_histogram", "active-lane histogram", "instructions",
     "warp instructions by number of active lanes, 0 to warp_width", ""},
    {"branches", "branches", "executions", "conditional branches, counted per warp",
     "smsp__sass_branch_targets.sum"},
    {"divergent_branches", "divergent branches", "executions", "of the branches, those whose lanes disagreed",
     "smsp__sass_branch_targets_threads_divergent.sum"},
    {"sfu_instructions", "SFU instructions", "instructions",
     "warp instructions on the special-function unit: reciprocals, roots, transcendental functions and "
     "conversions",
     "smsp__inst_executed_pipe_xu.sum"},
    {"instruction_mix", "instruction mix", "instructions", "warp and thread instructions by class", ""},
    {"global_load_requests", "global load requests", "requests", "loads from global memory, counted per warp",
     "l1tex__t_requests_pipe_lsu_mem_global_op_ld.sum"},
    {"global_load_sectors", "global load sectors", "sectors",
     "32-byte sectors that these touched, request by request",
     "l1tex__t_sectors_pipe_lsu_mem_global_op_ld.sum"},
    {"global_load_lines", "global load lines", "lines",
     "128-byte lines that these touched, request by request", ""},
    {"global_load_useful_bytes", "global load useful bytes", "bytes", "bytes that lanes asked for", ""},
    {"global_store_requests", "global store requests", "requests",
     "stores to global memory, counted per warp", "l1tex__t_requests_pipe_lsu_mem_global_op_st.sum"},
    {"global_store_sectors", "global store sectors", "sectors",
     "32-byte sectors that these touched, request by request",
     "l1tex__t_sectors_pipe_lsu_mem_global_op_st.sum"},
    {"global_store_lines", "global store lines", "lines",
     "128-byte lines that these touched, request by request", ""},
    {"global_store_useful_bytes", "global store useful bytes", "bytes", "bytes that lanes wrote", ""},
    {"shared_load_requests", "shared load requests", "requests",
     "loads from shared (__local) memory, counted per warp", "smsp__inst_executed_op_shared_ld.sum"},
    {"shared_load_useful_bytes", "shared load useful bytes", "bytes", "bytes that lanes asked for", ""},
    {"shared_store_requests", "shared store requests", "requests",
     "stores to shared (__local) memory, counted per warp", "smsp__inst_executed_op_shared_st.sum"},
    {"shared_store_useful_bytes", "shared store useful bytes", "bytes", "bytes that lanes wrote", ""},
    {"atomic_requests", "atomic requests", "requests", "atomic operations, counted per warp", ""},
    {"atomic_sectors", "atomic sectors", "sectors", "32-byte sectors that these touched, request by request",
     ""},
    {"atomic_lines", "atomic lines", "lines", "128-byte lines that these touched, request by request", ""},
    {"atomic_useful_bytes", "atomic useful bytes", "bytes", "bytes that lanes read and wrote", ""},
    {"global_load_sectors_per_request", "global load sectors per request", "sectors",
     "global_load_sectors / global_load_requests",
     "l1tex__average_t_sectors_per_request_pipe_lsu_mem_global_op_ld.ratio"},
    {"global_load_lines_per_request", "global load lines per request", "lines",
     "global_load_lines / global_load_requests", ""},
    {"global_load_efficiency", "global load efficiency", "ratio",
     "global_load_useful_bytes / (32 * global_load_sectors): useful over fetched bytes; above 1 where lanes "
     "share them",
     "smsp__sass_average_data_bytes_per_sector_mem_global_op_ld.pct"},
    {"global_store_sectors_per_request", "global store sectors per request", "sectors",
     "global_store_sectors / global_store_requests",
     "l1tex__average_t_sectors_per_request_pipe_lsu_mem_global_op_st.ratio"},
    {"global_store_lines_per_request", "global store lines per request", "lines",
     "global_store_lines / global_store_requests", ""},
    {"global_store_efficiency", "global store efficiency", "ratio",
     "global_store_useful_bytes / (32 * global_store_sectors): useful over fetched bytes; above 1 where "
     "lanes share them",
     "smsp__sass_average_data_bytes_per_sector_mem_global_op_st.pct"},
    {"atomic_sectors_per_request", "atomic sectors per request", "sectors",
     "atomic_sectors / atomic_requests", ""},
    {"atomic_lines_per_request", "atomic lines per request", "lines", "atomic_lines / atomic_requests", ""},
    {"atomic_efficiency", "atomic efficiency", "ratio",
     "atomic_useful_bytes / (32 * atomic_sectors): useful over fetched bytes; above 1 where lanes share them",
     ""},
    {"sectors_per_load", "sectors per load", "sectors", "global_load_sectors / global_load_requests",
     "l1tex__average_t_sectors_per_request_pipe_lsu_mem_global_op_ld.ratio"},
    {"lane_slots_lost", "lost lane slots", "lane slots",
     "lane slots (a lane of an issued warp instruction) in which a lane idled; of a branch: because the "
     "branch had "
     "parted it from the lanes that ran",
     ""},
    {"loss_share", "share of the loss", "ratio", "of a branch: lane_slots_lost over all that the launch lost",
     ""},
    {"lane_slots_idle", "idle lane slots", "lane slots",
     "of a line or block: lane slots without a lane while it was issued, whatever the cause", ""},
    {"lane_slots_never_used", "lane slots never used", "lane slots",
     "lane slots of lanes that do not exist: warps that are not full from the start", ""},
};

}  // namespace

std::span<const Metric> metrics() { return table; }

const Metric& metric(std::string_view key) {
  const auto* const found =
      std::find_if(std::begin(table), std::end(table), [&](const Metric& m) { return m.key == key; });
  if (found != std::end(table)) return *found;
  std::vector<std::string_view> keys;
  for (const Metric& m : table) keys.push_back(m.key);
  throw_unknown_name("metrics", "metric", key, keys);
}

}  // namespace warpgrain::reports
