#include "reports/html/table.hpp"

#include <fmt/format.h>
#include <utility>

#include "core/error.hpp"
#include "reports/html/page.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {

Cell text_cell(std::string_view text) { return {escape(text), {}, {}}; }

Cell wrapped_cell(std::string_view text) {
  return {fmt::format("<span class=\"wrap\">{}</span>", escape(text)), {}, {}};
}

Cell count_cell(std::uint64_t count) { return {count_text(count), static_cast<double>(count), {}}; }

Cell number_cell(double value, int decimals) { return {fixed_text(value, decimals), value, {}}; }

Cell share_cell(double part, double whole) {
  const double share = whole == 0 ? 0 : part / whole;
  return {fmt::format("{}<span class=\"bar\"><i style=\"--h:{:.4f}\"></i></span>", percent_text(part, whole),
                      share),
          share,
          {}};
}

Cell optional_cell(std::optional<double> value, int decimals) {
  return value ? number_cell(*value, decimals) : Cell{"-", {}, {}};
}

std::string explanation(const Metric& metric) { return explanation(metric.definition, metric.key); }

std::string explanation(std::string_view words, std::string_view metric_key) {
  const Metric& m = metric(metric_key);
  return m.ncu_metric.empty() ? std::string(words)
                              : fmt::format("{}\nNsight Compute: {}", words, m.ncu_metric);
}

Table::Column Table::of_metric(std::string_view key) {
  const Metric& m = metric(key);
  return {std::string(m.label), explanation(m)};
}

Table::Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

void Table::add_row(std::vector<Cell> cells) {
  if (cells.size() != columns_.size())
    throw_input_error("table row", fmt::format("{} cells", cells.size()), fmt::format("{}", columns_.size()));
  rows_.push_back(std::move(cells));
}

void Table::set_footer(std::vector<Cell> cells) { footer_ = std::move(cells); }

std::string Table::row_html(const std::vector<Cell>& cells) const {
  std::string html = "<tr>";
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Cell& cell = cells[c];
    std::string attributes;
    if (columns_[c].is_text || cell.heat)
      attributes += fmt::format(" class=\"{}\"", !cell.heat            ? "text"
                                                 : columns_[c].is_text ? "text heat"
                                                                       : "heat");
    if (cell.sort_by) attributes += fmt::format(" data-v=\"{}\"", *cell.sort_by);
    if (cell.heat) attributes += fmt::format(" style=\"--h:{:.3f}\"", *cell.heat);
    html += fmt::format("<td{}>{}</td>", attributes, cell.html);
  }
  return html + "</tr>\n";
}

std::string Table::heading_html(const Column& column) {
  return fmt::format("<th{} title=\"{}\">{}</th>", column.is_text ? " class=\"text\"" : "",
                     escape(column.explanation), escape(column.heading));
}

std::string Table::html() const {
  // A table of more than a screen scrolls by itself, so that what follows it is not far.
  constexpr std::size_t rows_of_a_screen = 40;
  std::string html = fmt::format("<div class=\"scroll{}\"><table class=\"sortable\">\n<thead><tr>",
                                 rows_.size() > rows_of_a_screen ? " tall" : "");
  for (const Column& column : columns_) html += heading_html(column);
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows_) html += row_html(row);
  html += "</tbody>\n";
  if (!footer_.empty()) html += "<tfoot>" + row_html(footer_) + "</tfoot>\n";
  return html + "</table></div>\n";
}

}  // namespace warpgrain::reports::html
