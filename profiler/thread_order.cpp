#include "profiler/thread_order.hpp"

#include <charconv>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::profiler {

std::string ThreadOrder::name() const {
  switch (kind) {
    case Kind::shuffled:
      return fmt::format("shuffled:{}", seed);
    case Kind::sorted:
      return "sorted:" + key;
    case Kind::launched:
      break;
  }
  return "launched";
}

ThreadOrder ThreadOrder::from_name(std::string_view name, std::string_view where) {
  const std::size_t colon = name.find(':');
  const std::string_view kind = name.substr(0, colon);
  const bool has_detail = colon != std::string_view::npos;
  const std::string_view detail = has_detail ? name.substr(colon + 1) : std::string_view();
  ThreadOrder order;
  if (kind == "launched" && !has_detail) return order;
  if (kind == "shuffled") {
    order.kind = Kind::shuffled;
    const char* const end = detail.data() + detail.size();
    const auto [stop, error] = std::from_chars(detail.data(), end, order.seed);
    if (!has_detail || (error == std::errc{} && stop == end)) return order;
  }
  if (kind == "sorted" && (!has_detail || !detail.empty())) {
    order.kind = Kind::sorted;
    if (has_detail) order.key = detail;
    return order;
  }
  throw_input_error(where, fmt::format("order '{}'", name),
                    "launched, shuffled, shuffled:SEED, sorted or sorted:KEY");
}

}  // namespace warpgrain::profiler
