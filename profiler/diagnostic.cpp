#include "profiler/diagnostic.hpp"

#include <fmt/format.h>

namespace warpgrain::profiler {
namespace {

std::string id_text(const std::array<std::uint64_t, 3>& id) {
  return fmt::format("({}, {}, {})", id[0], id[1], id[2]);
}

std::string access_text(const Diagnostic& d) {
  if (d.access.empty()) return {};
  const std::string_view preposition = d.access == "load" ? "from" : d.access == "store" ? "to" : "on";
  std::string text = fmt::format("{} of {} bytes {} {} memory", d.access, d.bytes, preposition, d.space);
  if (!d.buffer.empty()) text += fmt::format(", '{}' at byte {} of {}", d.buffer, d.offset, d.buffer_bytes);
  return text;
}

}  // namespace

std::string_view diagnostic_kind_name(DiagnosticKind kind) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(DiagnosticKind::count)> names{
      "out_of_bounds",      "null_pointer", "misaligned",        "read_only_write",    "write_only_read",
      "uninitialized_read", "data_race",    "subvector_race",    "barrier_divergence", "trap",
      "invalid_call",       "endless_loop", "instruction_limit", "trace_limit"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string place_text(const DiagnosticPlace& place) {
  if (place.line == 0) return fmt::format("PTX line {}", place.ptx_line);
  return fmt::format("{}:{} (PTX line {})", place.file, place.line, place.ptx_line);
}

std::string diagnostic_text(const Diagnostic& d) {
  std::string text =
      fmt::format("{}: {}: {}", place_text(d.place), diagnostic_kind_name(d.kind), access_text(d));
  const auto append = [&](const std::string& part) {
    if (!text.ends_with(": ")) text += ", ";
    text += part;
  };
  if (!d.detail.empty()) append(d.detail);
  append(fmt::format("work-item {} in work-group {}", id_text(d.work_item), id_text(d.work_group)));
  if (d.other) {
    const std::string who = d.other->work_item ? "work-item " + id_text(*d.other->work_item) : "another one";
    append(fmt::format("after the {} by {} at {}", d.other->access, who, place_text(d.other->place)));
  }
  if (d.count > 1) text += fmt::format("; {} times", d.count);
  return text;
}

}  // namespace warpgrain::profiler
