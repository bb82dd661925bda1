#include "variants/kernel_sources.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "kernels/embedded_kernels.hpp"

namespace warpgrain {
namespace {

void skip_blanks(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
}

// What follows the '#' of a directive; empty for every other line.
std::string_view directive(std::string_view line) {
  skip_blanks(line);
  if (!line.starts_with('#')) return {};
  line.remove_prefix(1);
  skip_blanks(line);
  return line;
}

// Behind these the text before may have been left out, and the #line in it.
bool is_branch(std::string_view line) {
  const std::string_view name = directive(line);
  return name.starts_with("else") || name.starts_with("elif") || name.starts_with("endif");
}

// The file that a line #includes with quotes; empty for every other line.
std::string_view included_file(std::string_view line) {
  line = directive(line);
  if (!line.starts_with("include")) return {};
  line.remove_prefix(7);
  skip_blanks(line);
  if (!line.starts_with('"')) return {};
  line.remove_prefix(1);
  const std::size_t quote = line.find('"');
  return quote == std::string_view::npos ? std::string_view{} : line.substr(0, quote);
}

}  // namespace

KernelSources::KernelSources(const std::filesystem::path& folder) : folder_(folder) {
  if (folder_.empty()) return;
  if (!std::filesystem::is_directory(folder_)) {
    throw_input_error(folder_.string(), "not a folder", "a folder of kernel files");
  }
  const bool shadows_one = std::ranges::any_of(embedded_kernels(), [this](const EmbeddedKernel& kernel) {
    return std::filesystem::is_regular_file(folder_ / kernel.path);
  });
  if (!shadows_one) {
    std::string names;
    for (const EmbeddedKernel& kernel : embedded_kernels()) names += fmt::format(" {}", kernel.path);
    throw_input_error(folder_.string(), "no kernel file there", "some of:" + names);
  }
}

bool KernelSources::find(std::string_view path, File& file) const {
  if (!folder_.empty()) {
    const std::filesystem::path shadow = folder_ / path;
    if (std::filesystem::is_regular_file(shadow)) {
      std::ifstream in(shadow, std::ios::binary);
      std::ostringstream text;
      text << in.rdbuf();
      if (!in || !text) throw_input_error(shadow.string(), "cannot be read");
      file = {shadow.string(), text.str()};
      return true;
    }
  }
  const auto it = std::ranges::find(embedded_kernels(), path, &EmbeddedKernel::path);
  if (it == embedded_kernels().end()) return false;
  file = {fmt::format("kernels/{}", path), std::string(it->text)};
  return true;
}

void KernelSources::append(std::string_view path, std::string_view included_from, std::string& text,
                           std::vector<std::string>& done) const {
  if (std::ranges::find(done, path) != done.end()) return;
  done.emplace_back(path);
  File file;
  if (!find(path, file)) {
    throw_input_error(included_from.empty() ? "kernels" : included_from,
                      fmt::format("no kernel file '{}'", path));
  }
  text += fmt::format("#line 1 \"{}\"\n", file.shown_path);
  std::istringstream lines(file.text);
  std::string line;
  bool has_included = false;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string_view included = included_file(line);
    if (included.empty()) {
      text += line;
      text += '\n';
      if (has_included && is_branch(line))
        text += fmt::format("#line {} \"{}\"\n", number + 1, file.shown_path);
    } else {
      has_included = true;
      append(included, fmt::format("{}:{}", file.shown_path, number), text, done);
      text += fmt::format("#line {} \"{}\"\n", number + 1, file.shown_path);
    }
  }
}

std::string KernelSources::bundle(std::span<const std::string> files) const {
  std::string text;
  std::vector<std::string> done;
  for (const std::string& file : files) append(file, {}, text, done);
  return text;
}

}  // namespace warpgrain
