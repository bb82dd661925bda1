// `warpgrain man`: the manual page, from the text behind --help.

#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>

#include "cli/app.hpp"
#include "cli/help_text.hpp"
#include "reports/generator.hpp"

namespace warpgrain::cli {
namespace {

// roff: a backslash is an escape, a hyphen is a minus only as \-, and a line must not begin with a control
// character.
std::string roff(std::string_view text) {
  std::string result = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      result += "\\\\";
    else if (c == '-')
      result += "\\-";
    else if (c != '`')
      result += c;
  }
  return result;
}

void write_options(std::string& page, const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    std::string names;
    for (const std::string& name : option->get_snames())
      names += fmt::format("{}-{}", names.empty() ? "" : ", ", name);
    for (const std::string& name : option->get_lnames())
      names += fmt::format("{}--{}", names.empty() ? "" : ", ", name);
    if (names.empty()) names = option->get_name();
    page += fmt::format(".TP\n.B {}\n{}\n", roff(names), roff(option->get_description()));
  }
}

int print_page() {
  Action unused;
  const auto app = make_app(unused);
  std::string page = fmt::format(
      ".TH WARPGRAIN 1 \"\" \"warpgrain {}\" \"User Commands\"\n.SH NAME\nwarpgrain \\- divergence, cost and "
      "error of "
      "particle kernels\n.SH SYNOPSIS\n.B warpgrain\n.I COMMAND\n[options]\n.SH DESCRIPTION\n{}\n.SH EXIT "
      "STATUS\n0: done; 1: ran and found what it was told to fail on; 2: the call or an input is wrong, with "
      "one "
      "line on stderr that says what, where and what was expected.\n",
      roff(reports::this_generator().version), roff(app->get_description()));
  for (const CLI::App* command : app->get_subcommands({})) {
    page += fmt::format(".SH COMMAND {}\n{}\n", roff(command->get_name()), roff(command->get_description()));
    write_options(page, *command);
  }
  std::cout << page;
  return 0;
}

}  // namespace

void add_man_command(CLI::App& app, Action& chosen) {
  CLI::App& command = *app.add_subcommand("man", help_text().summary("man"));
  command.callback([&chosen] { chosen = [] { return print_page(); }; });
}

}  // namespace warpgrain::cli
