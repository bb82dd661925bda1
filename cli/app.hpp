#pragma once
// The command `warpgrain`: parses a call, runs the subcommand, and turns every error into one line on stderr.

#include <CLI/App.hpp>
#include <functional>
#include <memory>

namespace warpgrain::cli {

// What a parsed subcommand wants done; returns the exit status.
using Action = std::function<int()>;

// Each adds its subcommand to `app`; parsing a call of it leaves the action in `chosen`.
void add_list_command(CLI::App& app, Action& chosen);
void add_run_command(CLI::App& app, Action& chosen);
void add_profile_command(CLI::App& app, Action& chosen);
void add_record_command(CLI::App& app, Action& chosen);
void add_sweep_command(CLI::App& app, Action& chosen);
void add_measure_command(CLI::App& app, Action& chosen);
void add_paper_command(CLI::App& app, Action& chosen);
void add_report_command(CLI::App& app, Action& chosen);
void add_merge_command(CLI::App& app, Action& chosen);
void add_compare_command(CLI::App& app, Action& chosen);
void add_completion_command(CLI::App& app, Action& chosen);
void add_man_command(CLI::App& app, Action& chosen);
void add_accuracy_command(CLI::App& app, Action& chosen);
void add_stability_command(CLI::App& app, Action& chosen);

// The whole command, ready to parse.
std::unique_ptr<CLI::App> make_app(Action& chosen);

// 0: done; 1: ran and found what it was told to fail on; 2: the call or an input is wrong.
int run_app(int argc, const char* const* argv);

}  // namespace warpgrain::cli
