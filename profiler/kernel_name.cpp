#include "profiler/kernel_name.hpp"

#include <algorithm>
#include <cstdlib>
#include <cxxabi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <vector>

#include "core/error.hpp"

namespace warpgrain::profiler {
namespace {

// Where the parameter list opens: the '(' of depth 0 that closes last.
std::size_t parameters_at(std::string_view name) {
  int depth = 0;
  for (std::size_t i = name.size(); i-- > 0;) {
    if (name[i] == ')') ++depth;
    if (name[i] == '(' && --depth == 0) return i;
  }
  return name.size();
}

// Behind the last blank and, when they are not wanted, the namespaces, outside of <...> and (...).
std::string_view last_part(std::string_view name, bool keep_namespaces) {
  int depth = 0;
  for (std::size_t i = name.size(); i-- > 0;) {
    if (name[i] == '>' || name[i] == ')') ++depth;
    if (name[i] == '<' || name[i] == '(') --depth;
    if (depth == 0 && (name[i] == ' ' || (name[i] == ':' && !keep_namespaces))) return name.substr(i + 1);
  }
  return name;
}

std::string_view without_template_arguments(std::string_view name) { return name.substr(0, name.find('<')); }

bool fits(std::string_view readable, std::string_view asked) {
  const std::string_view plain = last_part(readable, false);
  return asked == readable || asked == plain || asked == without_template_arguments(readable) ||
         asked == without_template_arguments(plain);
}

}  // namespace

std::string readable_kernel_name(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> demangled(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), std::free);
  if (status != 0 || !demangled) return symbol;
  const std::string_view name(demangled.get());
  return std::string(last_part(name.substr(0, parameters_at(name)), true));
}

std::string_view find_kernel(std::span<const std::string_view> symbols, std::string_view asked,
                             std::string_view where) {
  if (const auto found = std::ranges::find(symbols, asked); found != symbols.end()) return *found;
  std::vector<std::string> readable;
  std::vector<std::size_t> fitting;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    readable.push_back(readable_kernel_name(std::string(symbols[i])));
    if (fits(readable.back(), asked)) fitting.push_back(i);
  }
  if (fitting.size() == 1) return symbols[fitting[0]];
  if (fitting.size() > 1) {
    std::vector<std::string_view> names;
    for (const std::size_t i : fitting) names.push_back(readable[i]);
    throw_input_error(where, fmt::format("kernel '{}' is one of several", asked),
                      fmt::format("one of {}, or its symbol", fmt::join(names, ", ")));
  }
  throw_unknown_name(where, "kernel", asked, std::vector<std::string_view>(readable.begin(), readable.end()));
}

}  // namespace warpgrain::profiler
