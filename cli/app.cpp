#include "cli/app.hpp"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "reports/generator.hpp"

namespace warpgrain::cli {
namespace {

constexpr int wrong_call = 2;

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional()) names.push_back(option->get_name());
  return names;
}

// The library's message names what it did not expect; ours adds what would have been.
std::string describe(const CLI::ParseError& error, const CLI::App& app) {
  std::string message = error.what();
  std::replace(message.begin(), message.end(), '\n', ' ');
  const auto called = app.get_subcommands();
  const std::string name = called.empty() ? "warpgrain" : "warpgrain " + called.front()->get_name();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) && !called.empty())
    message += fmt::format("; valid: {}", fmt::join(option_names(*called.front()), ", "));
  return fmt::format("{}: {}", name, message);
}

int fail(std::string_view message) {
  std::cerr << message << '\n';
  return wrong_call;
}

}  // namespace

std::unique_ptr<CLI::App> make_app(Action& chosen) {
  auto app = std::make_unique<CLI::App>(
      "Shows where SIMT hardware wastes its lanes on discrete element method kernels, and what a faster "
      "variant "
      "costs in accuracy.",
      "warpgrain");
  const reports::Generator generator = reports::this_generator();
  app->set_version_flag("--version",
                        fmt::format("warpgrain {} ({})", generator.version, generator.git_revision));
  app->require_subcommand(1);
  add_list_command(*app, chosen);
  add_run_command(*app, chosen);
  add_compare_command(*app, chosen);
  add_stability_command(*app, chosen);
#ifdef WARPGRAIN_HAS_SIMULATOR
  add_profile_command(*app, chosen);
  add_record_command(*app, chosen);
  add_sweep_command(*app, chosen);
  add_measure_command(*app, chosen);
  add_paper_command(*app, chosen);
  add_accuracy_command(*app, chosen);
#else
  for (const char* name : {"profile", "record", "sweep", "measure", "paper", "accuracy"})
    app->add_subcommand(name, help_text().summary(name))->allow_extras()->callback([name, &chosen] {
      chosen = [name]() -> int {
        throw_input_error(fmt::format("warpgrain {}", name), "this build has no simulator",
                          "a build configured with WARPGRAIN_SIMULATOR=ON, which needs LLVM 15");
      };
    });
#endif
  add_report_command(*app, chosen);
  add_merge_command(*app, chosen);
  add_completion_command(*app, chosen);
  add_man_command(*app, chosen);
  return app;
}

int run_app(int argc, const char* const* argv) {
  set_command_line(argc, argv);
  Action chosen;
  try {
    const auto app = make_app(chosen);
    if (argc > 1 && argv[1][0] != '-') {
      std::vector<std::string> names;
      for (const CLI::App* command : app->get_subcommands({})) names.push_back(command->get_name());
      const std::vector<std::string_view> valid(names.begin(), names.end());
      if (std::find(valid.begin(), valid.end(), argv[1]) == valid.end())
        throw_unknown_name("warpgrain", "command", argv[1], valid);
    }
    try {
      app->parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      const auto called = app->get_subcommands();
      std::cout << (called.empty() ? app.get() : called.front())->help();
      return 0;
    } catch (const CLI::CallForVersion& version) {
      std::cout << version.what() << '\n';
      return 0;
    } catch (const CLI::ParseError& error) {
      return fail(describe(error, *app));
    }
    const int status = chosen();
    std::cout.flush();
    if (!std::cout) return fail("warpgrain: stdout: could not write the result");
    return status;
  } catch (const InputError& error) {
    return fail(error.what());
  } catch (const Interrupted&) {
    std::cerr << "warpgrain: interrupted\n";
    return interrupted_status;
  } catch (const std::bad_alloc&) {
    return fail("warpgrain: not enough memory for this call");
  } catch (const std::exception& error) {
    return fail(fmt::format("warpgrain: internal error: {}", error.what()));
  }
}

}  // namespace warpgrain::cli
