#include "profiler/printf_function.hpp"

#include <bit>
#include <span>
#include <string>

#include "profiler/printf_format.hpp"

namespace warpgrain::profiler {
namespace {

class SeparateArguments final : public PrintfArguments {
 public:
  SeparateArguments(std::span<const std::byte* const> places, const std::uint32_t* sizes)
      : places_(places), sizes_(sizes) {}

  std::span<const std::byte> next(std::size_t) override {
    if (next_ == places_.size()) return {};
    const std::size_t i = next_++;
    return {places_[i], sizes_[i]};
  }
  std::string_view text_at(const char* address) override { return address; }

 private:
  std::span<const std::byte* const> places_;
  const std::uint32_t* sizes_;
  std::size_t next_ = 0;
};

class PackedArguments final : public PrintfArguments {
 public:
  explicit PackedArguments(const std::byte* packed) : packed_(packed) {}

  std::span<const std::byte> next(std::size_t bytes) override {
    const std::size_t alignment = std::bit_ceil(bytes);
    end_ = (end_ + alignment - 1) / alignment * alignment;
    const std::span<const std::byte> argument(packed_ + end_, bytes);
    end_ += bytes;
    return argument;
  }
  std::string_view text_at(const char* address) override { return address; }

 private:
  const std::byte* packed_;
  std::size_t end_ = 0;
};

}  // namespace

std::int32_t print_arguments(LaneContext* lane, const char* format, const std::byte* const* arguments,
                             const std::uint32_t* sizes, std::uint32_t count) {
  if (lane->printed == nullptr) return -1;
  SeparateArguments separate({arguments, count}, sizes);
  *lane->printed += format_printf(format, separate);
  return 0;
}

std::int32_t print_packed(LaneContext* lane, const char* format, const std::byte* packed) {
  if (lane->printed == nullptr) return -1;
  PackedArguments arguments(packed);
  *lane->printed += format_printf(format, arguments);
  return 0;
}

}  // namespace warpgrain::profiler
