#include "cli/common_options.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "cli/help_text.hpp"
#include "core/error.hpp"

namespace warpgrain::cli {

std::string option_text(const CLI::App& command, const std::string& name) {
  return help_text().option(command.get_name(), name);
}

CLI::Option* add_flag(CLI::App& command, const std::string& name, bool& value) {
  return command.add_flag(name, value, option_text(command, name));
}

std::string whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (!text.empty() && error == std::errc{} && stop == end) return {};
  return fmt::format("'{}'; expected a whole number from 0 on", text);
}

std::string finite_number(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (!text.empty() && error == std::errc{} && stop == end && std::isfinite(number)) return {};
  return fmt::format("'{}'; expected a finite number", text);
}

namespace {

// Folders that are missing are made when the file is written (output.hpp).
std::string output_file(const std::string& text) {
  if (text == "-") return {};
  std::error_code error;
  if (text.empty() || std::filesystem::is_directory(text, error))
    return fmt::format("'{}'; expected a file to write", text);
  std::filesystem::path folder = std::filesystem::absolute(text).parent_path();
  while (!std::filesystem::exists(folder, error) && folder != folder.root_path())
    folder = folder.parent_path();
  if (std::filesystem::is_directory(folder, error) && access(folder.c_str(), W_OK) == 0) return {};
  return fmt::format("'{}': nothing can be written to '{}'; expected a writable place", text,
                     folder.string());
}

std::string above_zero(const std::string& text) {
  if (whole_number(text).empty() && text.find_first_not_of('0') != std::string::npos) return {};
  return fmt::format("'{}'; expected a whole number above 0", text);
}

}  // namespace

CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& value) {
  return add_option(command, name, value)->check(output_file, "");
}

CLI::Option* SceneOptions::add_to(CLI::App& command) {
  CLI::Option* option = add_option(command, "--scene", scene);
  add_option(command, "--particles", particles)->check(above_zero, "");
  add_option(command, "--seed", seed);
  return option;
}

Scene SceneOptions::load() const { return load_scene(scene, {particles, seed}); }

void VariantOptions::add_to(CLI::App& command) {
  add_option(command, "--variant", variant)->group("Variant");
  for (std::size_t a = 0; a < n_axes; ++a) {
    const Axis& axis = axes()[a];
    std::string names;
    for (const AxisValue& value : axis.values)
      names += fmt::format("{}{}", names.empty() ? "" : "|", value.name);
    command
        .add_option(
            fmt::format("--{}", axis.name), values[a],
            fmt::format("{}: {}; default {}", axis.summary, names, axis.values[axis.default_value].name))
        ->group("Variant");
  }
}

Variant VariantOptions::resolve(const Scene& scene, const std::string& kernel_folder) const {
  Variant resolved;
  if (scene.model.contact == ContactModel::simple) resolved.set("contact", "simple");
  if (variant) resolved = Variant::parse(*variant);
  const bool names_model = variant && variant->find("/model=") != std::string::npos;
  if (!kernel_folder.empty() && !names_model) resolved.set("model", "full");
  for (std::size_t a = 0; a < n_axes; ++a)
    if (values[a]) resolved.set(axes()[a].name, *values[a]);
  return resolved;
}

void DeviceOptions::add_to(CLI::App& command) {
  add_option(command, "--device", device);
  add_option(command, "--threads", threads);
  add_option(command, "--kernels", kernels);
  add_option(command, "--compiler", compiler);
}

BackendOptions DeviceOptions::backend_options() const {
  BackendOptions options;
  options.device = device;
  options.threads = threads;
  options.kernel_folder = kernels;
  options.compiler = kernel_compiler(compiler, "--compiler");
  return options;
}

void DeviceOptions::add_keeping_to(CLI::App& command) { add_option(command, "--keep-ptx", keep_ptx); }

BackendOptions DeviceOptions::backend_options(std::string_view backend) const {
  BackendOptions options = backend_options();
  options.ptx_folder = keep_ptx;
  if (!keep_ptx.empty() && backend != "opencl")
    throw_input_error("--keep-ptx", fmt::format("the back end {}", backend),
                      "--backend opencl, whose driver compiles the kernels");
  if (options.compiler != KernelCompiler::clang && backend != "cuda" && backend != "simt")
    throw_input_error("--compiler", fmt::format("{} on the back end {}", compiler, backend),
                      "--backend cuda or simt, which take PTX");
  return options;
}

void OutputOptions::add_to(CLI::App& command) {
  add_output_file(command, "--json", json);
  add_flag(command, "--quiet", quiet);
}

}  // namespace warpgrain::cli
