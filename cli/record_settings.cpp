#include "cli/record_settings.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

namespace warpgrain::cli {
namespace {

constexpr const char* folder_name = "WARPGRAIN_RECORD_FOLDER";
constexpr const char* kernels_name = "WARPGRAIN_RECORD_KERNELS";
constexpr const char* numbers_name = "WARPGRAIN_RECORD_NUMBERS";

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

std::string without_separators(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

std::vector<std::string> environment_of(const RecordSettings& settings) {
  std::string kernels;
  for (const std::string& pattern : settings.kernels) kernels += pattern + '\n';
  std::ostringstream numbers;
  numbers << settings.first << ' ' << settings.every << ' ' << settings.largest << ' ' << settings.memory;
  return {std::string(folder_name) + '=' + settings.folder.string(),
          std::string(kernels_name) + '=' + kernels, std::string(numbers_name) + '=' + numbers.str()};
}

RecordSettings settings_of_environment() {
  RecordSettings settings;
  std::istringstream numbers(variable(numbers_name));
  if (!(numbers >> settings.first >> settings.every >> settings.largest >> settings.memory)) return {};
  std::istringstream kernels(variable(kernels_name));
  for (std::string pattern; std::getline(kernels, pattern);) settings.kernels.push_back(pattern);
  settings.folder = variable(folder_name);
  return settings;
}

std::string index_line(const RecordedLaunch& launch) {
  return without_separators(launch.kernel) + '\t' + launch.file + '\t' + without_separators(launch.remark) +
         '\n';
}

std::vector<RecordedLaunch> read_index(const std::filesystem::path& folder) {
  std::vector<RecordedLaunch> launches;
  std::ifstream in(folder / record_index);
  for (std::string line; std::getline(in, line);) {
    RecordedLaunch launch;
    std::istringstream fields(line);
    std::getline(fields, launch.kernel, '\t');
    std::getline(fields, launch.file, '\t');
    std::getline(fields, launch.remark);
    launches.push_back(std::move(launch));
  }
  return launches;
}

}  // namespace warpgrain::cli
