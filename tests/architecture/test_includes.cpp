// The house's one rule of direction: includes point downwards. An arrow that is not in this table fails.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/paths.hpp"

namespace {

namespace fs = std::filesystem;

// Folder -> what its files may include beside their own folder: whole folders, or single headers.
const std::map<std::string, std::set<std::string>> allowed{
    {"core", {}},
    {"kernels", {"core"}},
    {"profiler", {"core/error.hpp"}},
    {"variants", {"core", "kernels", "profiler"}},
    {"analysis", {"core", "profiler/counters.hpp"}},
    {"reports",
     {"core", "analysis", "profiler/counters.hpp", "profiler/diagnostic.hpp", "profiler/profile.hpp",
      "profiler/launch.hpp", "profiler/kernel_graph.hpp", "profiler/timeline.hpp"}},
    {"cli", {"core", "kernels", "variants", "profiler", "analysis", "reports"}},
};

struct Include {
  std::string file, header;
  bool quoted;
};

std::vector<Include> includes_below(const fs::path& root, const std::string& folder) {
  static const std::regex line_pattern(R"(^\s*#\s*include\s+([<"])([^>"]+)[>"])");
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".cpp" && extension != ".hpp" && extension != ".h" && extension != ".cl") continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (std::regex_search(line, match, line_pattern))
        found.push_back({fs::relative(entry.path(), root).string(), match[2], match[1] == "\""});
    }
  }
  return found;
}

TEST(Includes, PointDownwards) {
  const fs::path root = warpgrain::source_path("");
  for (const auto& [folder, may_include] : allowed) {
    for (const Include& include : includes_below(root, folder)) {
      if (!include.quoted || include.header.find('/') == std::string::npos) continue;
      const std::string target = include.header.substr(0, include.header.find('/'));
      // Kernels name their own files relative to kernels/, which is where they are embedded from.
      if (target == folder || !allowed.count(target)) continue;
      EXPECT_TRUE(may_include.count(target) || may_include.count(include.header))
          << include.file << " includes " << include.header << ", which " << folder << "/ may not";
    }
  }
}

TEST(Includes, OnlyTheProfilersSourcesSeeLlvm) {
  const fs::path root = warpgrain::source_path("");
  for (const auto& [folder, unused] : allowed)
    for (const Include& include : includes_below(root, folder)) {
      if (include.header.rfind("llvm/", 0) != 0 && include.header.rfind("clang/", 0) != 0) continue;
      EXPECT_EQ(folder, "profiler") << include.file << " includes " << include.header;
    }
}

// What goes into other people's programs.
TEST(Includes, TheLayerTakesNoMoreThanWhatWritesLaunchFiles) {
  const std::set<std::string> headers{"core/error.hpp", "profiler/build_options.hpp",
                                      "profiler/launch_file.hpp", "cli/record_settings.hpp"};
  for (const Include& include : includes_below(warpgrain::source_path(""), "cli/layer"))
    EXPECT_TRUE(!include.quoted || include.header.rfind("cli/layer/", 0) == 0 ||
                headers.count(include.header))
        << include.file << " includes " << include.header;
}

TEST(Includes, AnalysisSeesNoDeviceHeaders) {
  const fs::path root = warpgrain::source_path("");
  for (const Include& include : includes_below(root, "analysis"))
    EXPECT_FALSE(include.header.rfind("CL/", 0) == 0 || include.header.rfind("cuda", 0) == 0)
        << include.file << " includes " << include.header;
}

}  // namespace
