#include "profiler/printf_function.hpp"

#include <bit>
#include <cstring>
#include <limits>
#include <span>
#include <string>

#include "profiler/printf_format.hpp"

namespace warpgrain::profiler {
namespace {

// A work-group that prints more has lost its way.
constexpr std::size_t max_printed = std::size_t{64} << 20;

// Of a string in the kernel's memory, as much as may be read.
std::string_view text_in(const LaneContext& lane, const char* address) {
  if (lane.readable == nullptr) return address;
  const std::uint64_t n = lane.readable(&lane, reinterpret_cast<std::uintptr_t>(address));
  if (n == 0) return "(no text)";
  return {address, strnlen(address, n)};
}

class SeparateArguments final : public PrintfArguments {
 public:
  SeparateArguments(const LaneContext& lane, std::span<const std::byte* const> places,
                    const std::uint32_t* sizes)
      : lane_(lane), places_(places), sizes_(sizes) {}

  std::span<const std::byte> next(std::size_t) override {
    if (next_ == places_.size()) return {};
    const std::size_t i = next_++;
    return {places_[i], sizes_[i]};
  }
  std::string_view text_at(const char* address) override { return text_in(lane_, address); }

 private:
  const LaneContext& lane_;
  std::span<const std::byte* const> places_;
  const std::uint32_t* sizes_;
  std::size_t next_ = 0;
};

class PackedArguments final : public PrintfArguments {
 public:
  PackedArguments(const LaneContext& lane, const std::byte* packed)
      : lane_(lane),
        packed_(packed),
        size_(lane.readable == nullptr ? std::numeric_limits<std::uint64_t>::max()
                                       : lane.readable(&lane, reinterpret_cast<std::uintptr_t>(packed))) {}

  std::span<const std::byte> next(std::size_t bytes) override {
    const std::size_t alignment = std::bit_ceil(bytes);
    end_ = (end_ + alignment - 1) / alignment * alignment;
    if (end_ + bytes > size_) return {};
    const std::span<const std::byte> argument(packed_ + end_, bytes);
    end_ += bytes;
    return argument;
  }
  std::string_view text_at(const char* address) override { return text_in(lane_, address); }

 private:
  const LaneContext& lane_;
  const std::byte* packed_;
  std::uint64_t size_;
  std::size_t end_ = 0;
};

}  // namespace

std::int32_t print_arguments(LaneContext* lane, const char* format, const std::byte* const* arguments,
                             const std::uint32_t* sizes, std::uint32_t count) {
  if (lane->printed == nullptr || lane->printed->size() > max_printed) return -1;
  SeparateArguments separate(*lane, {arguments, count}, sizes);
  *lane->printed += format_printf(text_in(*lane, format), separate);
  return 0;
}

std::int32_t print_packed(LaneContext* lane, const char* format, const std::byte* packed) {
  if (lane->printed == nullptr || lane->printed->size() > max_printed) return -1;
  PackedArguments arguments(*lane, packed);
  *lane->printed += format_printf(text_in(*lane, format), arguments);
  return 0;
}

}  // namespace warpgrain::profiler
