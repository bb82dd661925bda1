#pragma once
// Options that several subcommands share: declared once, with their texts from docs/cli.md.

#include <CLI/App.hpp>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/scene.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

// What docs/cli.md says of the option under the subcommand, or under "common".
std::string option_text(const CLI::App& command, const std::string& name);

// Checks of an option's text, as the library takes them: empty where nothing is wrong.
std::string whole_number(const std::string& text);  // from 0 on, of 64 bits
std::string finite_number(const std::string& text);

template <class T>
struct OptionValue {
  using Type = T;
};
template <class T>
struct OptionValue<std::optional<T>> {
  using Type = T;
};

// The library would take -1 for the largest number, and NaN for one.
template <class T>
CLI::Option* add_option(CLI::App& command, const std::string& name, T& value) {
  using Value = typename OptionValue<T>::Type;
  CLI::Option* option = command.add_option(name, value, option_text(command, name));
  if constexpr (std::is_floating_point_v<Value>)
    option->check(finite_number, "");
  else if constexpr (std::is_integral_v<Value>)
    option->check(whole_number, "");
  return option;
}
// A file that the command writes its result to, or "-". Refused here and not behind hours of work: a folder,
// or a place where nothing can be made.
CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& value);
CLI::Option* add_flag(CLI::App& command, const std::string& name, bool& value);

struct SceneOptions {
  std::string scene;
  std::optional<std::uint64_t> particles, seed;

  CLI::Option* add_to(CLI::App& command);  // returns --scene, for the command to require or exclude
  Scene load() const;
};

// One option an axis (--contact, --order, ...), from the axis tables, and --variant for all at once.
struct VariantOptions {
  std::optional<std::string> variant;
  std::array<std::optional<std::string>, n_axes> values;

  void add_to(CLI::App& command);
  // Without a contact law in the call the scene's model decides: a scene of the simple model runs `simple`.
  // Kernels of a folder (--kernels) have the full model unless the call says otherwise.
  Variant resolve(const Scene& scene, const std::string& kernel_folder) const;
};

struct DeviceOptions {
  std::string device;
  unsigned threads = 0;
  std::string kernels;
  std::string compiler = "clang";
  std::string keep_ptx;  // folder; empty: none

  void add_to(CLI::App& command);
  // Of commands that run on one back end.
  void add_keeping_to(CLI::App& command);
  // Throws InputError for a compiler that there is not.
  BackendOptions backend_options() const;
  // For a call that runs on that back end alone, which has to be one that takes PTX where --compiler stands,
  // and one that makes its own where --keep-ptx does.
  BackendOptions backend_options(std::string_view backend) const;
};

struct OutputOptions {
  std::string json;  // empty: none; "-": stdout
  bool quiet = false;

  void add_to(CLI::App& command);
  // Whether a summary for people goes to stdout: not when the JSON does.
  bool summary() const { return !quiet && json != "-"; }
};

}  // namespace warpgrain::cli
