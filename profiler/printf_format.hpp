#pragma once
// What OpenCL C's printf prints: C's conversions on host values, with vectors (`%v4hlf`). OpenCL C
// specification, section "printf".

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace warpgrain::profiler {

// Hands out a call's arguments from first to last.
class PrintfArguments {
 public:
  virtual ~PrintfArguments() = default;
  // The bytes of the next argument, of which the conversion asks for `bytes`; none when there is no further
  // argument.
  virtual std::span<const std::byte> next(std::size_t bytes) = 0;
  // The literal that an argument of %s points to.
  virtual std::string_view text_at(const char* address) = 0;
};

// An argument's own size wins over what its conversion says: `%v4f` prints a float4, too. A conversion that
// is none of OpenCL's, or that has no argument left, is printed as it stands there.
std::string format_printf(std::string_view format, PrintfArguments& arguments);

}  // namespace warpgrain::profiler
