#include "profiler/printf_format.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>

#include "profiler/half.hpp"

namespace warpgrain::profiler {
namespace {

// `%[flags][width][.precision][vN][length]conversion`
struct Conversion {
  std::string head;  // "%-08.3", as it stands there
  unsigned elements = 1;
  bool is_vector = false;
  std::size_t element_bytes = 0;  // as the length says, for a vector's elements
  std::size_t scalar_bytes = 0;   // as the length says, after the promotions of arguments
  char letter = 0;

  bool is_float() const { return std::string_view("fFeEgGaA").find(letter) != std::string_view::npos; }
  bool is_signed() const { return letter == 'd' || letter == 'i'; }
};

constexpr int max_width = 4096;  // of a field: what a kernel asks for must not fill the memory

class FormatReader {
 public:
  explicit FormatReader(std::string_view text) : text_(text) {}

  // The conversion behind the '%' that the text begins with; its length in characters is `size()`.
  std::optional<Conversion> read() {
    Conversion c;
    take_while("-+ #0");
    if (!take_number()) return std::nullopt;
    if (peek() == '.') {
      ++at_;
      if (!take_number()) return std::nullopt;
    }
    c.head = text_.substr(0, at_);
    if (peek() == 'v' && !take_vector(c)) return std::nullopt;
    take_length(c);
    c.letter = peek();
    if (c.letter == 0 || std::string_view("diouxXcspfFeEgGaA").find(c.letter) == std::string_view::npos)
      return std::nullopt;
    if (c.is_vector && (c.letter == 'c' || c.letter == 's' || c.letter == 'p')) return std::nullopt;
    ++at_;
    set_sizes(c);
    return c;
  }
  std::size_t size() const { return at_; }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void take_while(std::string_view set) {
    while (at_ < text_.size() && set.find(text_[at_]) != std::string_view::npos) ++at_;
  }
  bool take_number() {
    const std::size_t begin = at_;
    take_while("0123456789");
    int value = 0;
    const auto result = std::from_chars(text_.data() + begin, text_.data() + at_, value);
    return begin == at_ || (result.ec == std::errc{} && value <= max_width);
  }
  bool take_vector(Conversion& c) {
    ++at_;
    for (const unsigned n : {16U, 2U, 3U, 4U, 8U}) {
      const std::string digits = std::to_string(n);
      if (!text_.substr(at_).starts_with(digits)) continue;
      at_ += digits.size();
      c.elements = n;
      c.is_vector = true;
      return true;
    }
    return false;
  }
  void take_length(Conversion& c) {
    for (const auto& [name, bytes] : lengths) {
      if (!text_.substr(at_).starts_with(name)) continue;
      at_ += name.size();
      c.element_bytes = bytes;
      return;
    }
  }
  static void set_sizes(Conversion& c) {
    if (c.letter == 's' || c.letter == 'p') c.element_bytes = sizeof(std::uint64_t);
    if (c.element_bytes == 0) c.element_bytes = c.is_float() && !c.is_vector ? 8 : 4;
    // Smaller arguments are passed as int, or as double.
    c.scalar_bytes = c.is_float() ? 8 : std::max<std::size_t>(c.element_bytes, 4);
  }

  // ll, j, z and t are C's; CUDA takes them.
  static constexpr std::array<std::pair<std::string_view, std::size_t>, 8> lengths{
      {{"hh", 1}, {"hl", 4}, {"h", 2}, {"ll", 8}, {"l", 8}, {"j", 8}, {"z", 8}, {"t", 8}}};
  std::string_view text_;
  std::size_t at_ = 1;
};

// The C library's text for one value.
template <class Value>
std::string print(const std::string& format, Value value) {
  std::array<char, 512> small{};
  const int size = std::snprintf(small.data(), small.size(), format.c_str(), value);
  if (size < 0) return {};
  if (static_cast<std::size_t>(size) < small.size()) return {small.data(), static_cast<std::size_t>(size)};
  std::string text(static_cast<std::size_t>(size) + 1, '\0');
  std::snprintf(text.data(), text.size(), format.c_str(), value);
  text.pop_back();
  return text;
}

std::uint64_t low_bytes(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data(), std::min(bytes.size(), sizeof value));
  return value;
}

double float_value(std::span<const std::byte> bytes) {
  const std::uint64_t bits = low_bytes(bytes);
  if (bytes.size() >= 8) return std::bit_cast<double>(bits);
  if (bytes.size() >= 4) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  return half_to_float(static_cast<std::uint16_t>(bits));
}

std::string print_element(const Conversion& c, std::span<const std::byte> bytes) {
  if (c.is_float()) return print(c.head + c.letter, float_value(bytes));
  const std::size_t wanted = std::min({c.element_bytes, bytes.size(), sizeof(std::uint64_t)});
  const unsigned shift = 64 - 8 * static_cast<unsigned>(wanted);
  const std::uint64_t value = low_bytes(bytes) << shift;
  if (c.letter == 'c') return print(c.head + 'c', static_cast<int>(value >> shift));
  if (c.is_signed())
    return print(c.head + "ll" + c.letter, static_cast<long long>(static_cast<std::int64_t>(value) >> shift));
  return print(c.head + "ll" + c.letter, static_cast<unsigned long long>(value >> shift));
}

// nullopt: no argument is left
std::optional<std::string> print_argument(const Conversion& c, PrintfArguments& arguments) {
  const std::size_t slots = c.elements == 3 ? 4 : c.elements;
  const std::span<const std::byte> bytes =
      arguments.next(c.is_vector ? slots * c.element_bytes : c.scalar_bytes);
  if (bytes.size() < slots) return std::nullopt;
  if (c.letter == 's') {
    const auto* address = reinterpret_cast<const char*>(low_bytes(bytes));
    return print(c.head + 's',
                 address == nullptr ? "(null)" : std::string(arguments.text_at(address)).c_str());
  }
  if (c.letter == 'p') return print(c.head + 'p', reinterpret_cast<const void*>(low_bytes(bytes)));
  std::string text;
  Conversion element = c;
  if (c.is_vector) element.element_bytes = bytes.size() / slots;
  for (unsigned i = 0; i < c.elements; ++i) {
    if (i > 0) text += ',';
    text += print_element(element, bytes.subspan(i * (bytes.size() / slots), bytes.size() / slots));
  }
  return text;
}

}  // namespace

std::string format_printf(std::string_view format, PrintfArguments& arguments) {
  std::string out;
  while (!format.empty()) {
    const std::size_t percent = std::min(format.find('%'), format.size());
    out += format.substr(0, percent);
    format.remove_prefix(percent);
    if (format.empty()) break;
    if (format.starts_with("%%")) {
      out += '%';
      format.remove_prefix(2);
      continue;
    }
    FormatReader reader(format);
    const std::optional<Conversion> conversion = reader.read();
    const std::optional<std::string> text =
        conversion ? print_argument(*conversion, arguments) : std::nullopt;
    const std::size_t taken = std::clamp<std::size_t>(reader.size(), 1, format.size());
    out += text ? *text : std::string(format.substr(0, taken));
    format.remove_prefix(taken);
  }
  return out;
}

}  // namespace warpgrain::profiler
