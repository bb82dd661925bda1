#include "cli/recorded_program.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "core/error.hpp"

namespace warpgrain::cli {
namespace {

constexpr std::string_view layers_variable = "OPENCL_LAYERS=";

// This process's, with the layer behind others that it names.
std::vector<std::string> environment_with(const std::filesystem::path& layer,
                                          const RecordSettings& settings) {
  std::vector<std::string> environment = environment_of(settings);
  std::string layers = std::string(layers_variable);
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (std::string_view(*variable).starts_with(layers_variable))
      layers = fmt::format("{}:", *variable);
    else
      environment.emplace_back(*variable);
  }
  environment.push_back(layers + layer.string());
  return environment;
}

std::vector<char*> pointers_to(std::vector<std::string>& strings) {
  std::vector<char*> pointers;
  for (std::string& text : strings) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Ignores what the terminal sends to all of its programs, for as long as it lives.
class InterruptsIgnored {
 public:
  InterruptsIgnored() {
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGINT, &ignore, &interrupt_);
    sigaction(SIGQUIT, &ignore, &quit_);
  }
  ~InterruptsIgnored() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGQUIT, &quit_, nullptr);
  }
  InterruptsIgnored(const InterruptsIgnored&) = delete;
  InterruptsIgnored& operator=(const InterruptsIgnored&) = delete;

 private:
  struct sigaction interrupt_ = {}, quit_ = {};
};

}  // namespace

std::filesystem::path find_layer() {
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string name = "libwarpgrain_layer.so";
  for (const std::filesystem::path& candidate :
       {folder / "layer" / name, folder.parent_path() / "lib" / "warpgrain" / name})
    if (std::filesystem::exists(candidate)) return candidate;
  throw_input_error("warpgrain record", fmt::format("no {} beside {}", name, folder.string()),
                    "the layer that is built and installed with warpgrain");
}

int run_recorded(const std::vector<std::string>& words, const std::filesystem::path& layer,
                 const RecordSettings& settings) {
  std::vector<std::string> arguments = words;
  std::vector<std::string> environment = environment_with(layer, settings);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGINT);
  sigaddset(&defaults, SIGQUIT);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

  const InterruptsIgnored ignored;
  pid_t process = 0;
  const int error = posix_spawnp(&process, arguments[0].c_str(), nullptr, &attributes,
                                 pointers_to(arguments).data(), pointers_to(environment).data());
  posix_spawnattr_destroy(&attributes);
  if (error != 0)
    throw_input_error(
        "warpgrain record",
        fmt::format("'{}' cannot be started: {}", words[0], std::generic_category().message(error)),
        "a program and its arguments behind --");
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), words[0]);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace warpgrain::cli
