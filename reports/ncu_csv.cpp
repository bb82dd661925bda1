#include "reports/ncu_csv.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <sstream>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/metrics.hpp"

namespace warpgrain::reports {
namespace {

constexpr std::uintmax_t size_limit = std::uintmax_t{1} << 30;  // bytes

// The fields of a line, all of which ncu quotes; nothing for other lines.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  if (!line.starts_with('"')) return fields;
  std::string field;
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') {
      field += line[++k];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.push_back(std::move(field));
      field.clear();
    } else {
      field += c;
    }
  }
  fields.push_back(std::move(field));
  return fields;
}

// "1,234.5" as well as "1234.5".
std::optional<double> number(std::string text) {
  std::erase(text, ',');
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() ? std::optional(value)
                                                                             : std::nullopt;
}

}  // namespace

std::vector<NcuLaunch> read_ncu_csv(const std::filesystem::path& file) {
  std::istringstream lines(read_text_file(file, size_limit));
  std::vector<std::string> heading;
  std::size_t name_column = 0;
  std::vector<NcuLaunch> launches;
  int number_of_line = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number_of_line;
    if (line.ends_with('\r')) line.pop_back();
    const std::vector<std::string> fields = fields_of(line);
    const auto name = std::ranges::find(fields, "Kernel Name");
    if (name != fields.end()) {
      heading = fields;
      name_column = static_cast<std::size_t>(name - fields.begin());
      if (std::ranges::find(fields, "Metric Name") != fields.end())
        throw_input_error(fmt::format("{}:{}", file.string(), number_of_line), "another page of ncu's",
                          "ncu --csv --page raw");
      continue;
    }
    if (heading.empty() || fields.empty() || !number(fields[0])) continue;  // the row of units has no ID
    if (fields.size() != heading.size())
      throw_input_error(fmt::format("{}:{}", file.string(), number_of_line),
                        fmt::format("{} fields", fields.size()), fmt::format("{}", heading.size()));
    NcuLaunch& launch = launches.emplace_back();
    launch.kernel = fields[name_column].substr(0, fields[name_column].find('('));
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (heading[k].find("__") != std::string::npos)
        if (const auto value = number(fields[k])) launch.metrics[heading[k]] = *value;
  }
  if (heading.empty()) throw_input_error(file.string(), "no table of kernels", "ncu --csv --page raw");
  return launches;
}

std::map<std::string, double> counters_of(const NcuLaunch& launch) {
  std::map<std::string, double> counters;
  for (const Metric& metric : metrics()) {
    if (!metric.ncu_metric.ends_with(".sum")) continue;
    const auto found = launch.metrics.find(std::string(metric.ncu_metric));
    if (found != launch.metrics.end()) counters[std::string(metric.key)] = found->second;
  }
  return counters;
}

std::vector<std::string> ncu_metrics() {
  std::vector<std::string> names;
  for (const Metric& metric : metrics())
    if (metric.ncu_metric.ends_with(".sum") && std::ranges::find(names, metric.ncu_metric) == names.end())
      names.emplace_back(metric.ncu_metric);
  return names;
}

}  // namespace warpgrain::reports
