#pragma once
// Kernels by the names that users write: C++ mangles those that are not `extern "C"`.

#include <span>
#include <string>
#include <string_view>

namespace warpgrain::profiler {

// The name without its parameters as the source has it: "ns::reduce<float>" of "_ZN2ns6reduceIfEEvPT_". Other
// names stay as they are.
std::string readable_kernel_name(const std::string& symbol);

// The one of `symbols` that `asked` names: the symbol itself, or the readable name, with or without
// namespaces and template arguments, when only one fits. Throws InputError naming those there are.
std::string_view find_kernel(std::span<const std::string_view> symbols, std::string_view asked,
                             std::string_view where);

}  // namespace warpgrain::profiler
