// `warpgrain completion SHELL`: what a shell needs to complete calls, made of the options that there are.

#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/machine.hpp"
#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "core/error.hpp"
#include "core/scene.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {
namespace {

using Words = std::vector<std::string>;

// Options whose values have names, which are the same in every command.
std::map<std::string, Words> named_values() {
  std::map<std::string, Words> values{{"--weights", {"auto", "ptx", "sass"}},
                                      {"--policy", {"loop_postdom", "ipdom", "min_pc"}},
                                      {"--compiler", {"clang", "cuda", "nvidia"}},
                                      {"--assembler", {"driver", "ptxas"}}};
  for (const Axis& axis : axes()) {
    values["--axis"].push_back(fmt::format("{}=", axis.name));
    for (const AxisValue& value : axis.values)
      values[fmt::format("--{}", axis.name)].emplace_back(value.name);
  }
  for (const SceneSummary& scene : named_scenes()) values["--scene"].push_back(scene.name);
  for (const Machine& machine : named_machines()) values["--machine"].push_back(machine.name);
  for (const Backend& backend : backends()) values["--backend"].emplace_back(backend.name);
  return values;
}

Words options_of(const CLI::App& command) {
  Words names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) { return app.get_subcommands({}); }

std::string bash(const CLI::App& app) {
  Words commands;
  std::string options, values;
  for (const CLI::App* command : commands_of(app)) {
    commands.push_back(command->get_name());
    options +=
        fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), fmt::join(options_of(*command), " "));
  }
  for (const auto& [option, words] : named_values())
    values += fmt::format("    {}) words=\"{}\" ;;\n", option, fmt::join(words, " "));
  // Readline takes '=' for the end of a word.
  return fmt::format(R"(# bash: source <(warpgrain completion bash)
_warpgrain() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words=
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "{}" -- "$current")
    return
  fi
  case $before in
{}  esac
  [[ -z $words && $current == -* ]] && case ${{COMP_WORDS[1]}} in
{}  esac
  [[ -n $words ]] && mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}}
complete -o default -F _warpgrain warpgrain
)",
                     fmt::join(commands, " "), values, options);
}

std::string zsh(const CLI::App& app) {
  return "# zsh: source <(warpgrain completion zsh)\nautoload -U +X bashcompinit && bashcompinit\n" +
         bash(app);
}

// Within single quotes.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return result + "'";
}

std::string fish(const CLI::App& app) {
  std::string script = "# fish: warpgrain completion fish | source\n";
  const std::map<std::string, Words> values = named_values();
  for (const CLI::App* command : commands_of(app)) {
    script += fmt::format("complete -c warpgrain -n __fish_use_subcommand -f -a {} -d {}\n",
                          command->get_name(), in_quotes(command->get_description()));
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames()) {
        script += fmt::format("complete -c warpgrain -n '__fish_seen_subcommand_from {}' -l {} -d {}",
                              command->get_name(), name, in_quotes(option->get_description()));
        if (const auto found = values.find("--" + name); found != values.end())
          script += fmt::format(" -x -a {}", in_quotes(fmt::format("{}", fmt::join(found->second, " "))));
        script += '\n';
      }
  }
  return script;
}

struct Shell {
  std::string_view name;
  std::string (*script)(const CLI::App&);
};
constexpr std::array<Shell, 3> shells{{{"bash", bash}, {"fish", fish}, {"zsh", zsh}}};

int complete(const std::string& name) {
  std::vector<std::string_view> valid;
  Action unused;
  for (const Shell& shell : shells) {
    if (shell.name == name) {
      std::cout << shell.script(*make_app(unused));
      return 0;
    }
    valid.push_back(shell.name);
  }
  throw_unknown_name("warpgrain completion", "shell", name, valid);
}

}  // namespace

void add_completion_command(CLI::App& app, Action& chosen) {
  auto shell = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("completion", help_text().summary("completion"));
  add_option(command, "shell", *shell)->required();
  command.callback([shell, &chosen] { chosen = [shell] { return complete(*shell); }; });
}

}  // namespace warpgrain::cli
