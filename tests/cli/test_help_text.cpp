#include <gtest/gtest.h>
#include <set>
#include <string>

#include "cli/app.hpp"
#include "cli/help_text.hpp"
#include "variants/axes.hpp"

namespace warpgrain::cli {
namespace {

TEST(HelpText, ReadsSummariesAndOptions) {
  const HelpText text(
      "# page\nprose\n\n## common\nShared.\n\n| option | meaning |\n|---|---|\n| `--json` | Write JSON |\n\n"
      "## run\nRuns a scene\nto its end.\n\nMore prose.\n\n| option | meaning |\n|---|---|\n| `--steps` | So "
      "many |\n");
  EXPECT_EQ(text.summary("run"), "Runs a scene to its end.");
  EXPECT_EQ(text.option("run", "--steps"), "So many");
  EXPECT_EQ(text.option("run", "--json"), "Write JSON");
  EXPECT_THROW(text.option("run", "--no-such"), std::logic_error);
  EXPECT_THROW(text.summary("walk"), std::logic_error);
}

// The page has a row for every option of every command, and no row more. Axes are documented by their own
// tables.
TEST(HelpText, PageAndCommandsHaveTheSameOptions) {
  Action chosen;
  const auto app = make_app(chosen);
  std::set<std::string> axis_options;
  for (const Axis& axis : axes()) axis_options.insert("--" + std::string(axis.name));

  std::set<std::string> seen_common;
  for (const CLI::App* command : app->get_subcommands({})) {
    const auto section = help_text().sections().find(command->get_name());
    ASSERT_NE(section, help_text().sections().end()) << command->get_name();
    EXPECT_EQ(command->get_description(), section->second.summary);
    std::set<std::string> own;
    for (const CLI::Option* option : command->get_options()) {
      const std::string name = option->get_positional() ? option->get_name(true) : option->get_name();
      if (name == "--help" || axis_options.count(name)) continue;
      EXPECT_EQ(option->get_description(), help_text().option(command->get_name(), name)) << name;
      (section->second.options.count(name) ? own : seen_common).insert(name);
    }
    for (const auto& [name, text] : section->second.options)
      EXPECT_TRUE(own.count(name)) << command->get_name() << ": docs/cli.md has a row for " << name;
  }
  for (const auto& [name, text] : help_text().sections().at("common").options)
    EXPECT_TRUE(seen_common.count(name)) << "no command takes " << name;
}

}  // namespace
}  // namespace warpgrain::cli
