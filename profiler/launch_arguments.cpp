#include "profiler/launch_arguments.hpp"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <ostream>

#include "core/error.hpp"

namespace warpgrain::profiler {
namespace {

using Pointer = KernelParameter::Pointer;

// Fills one argument; knows where to point when something does not fit.
class Binder {
 public:
  Binder(const LaunchFile& file, std::size_t index, const KernelParameter& parameter,
         const ParameterDeclaration& declared)
      : path_(file.path.string()), given_(file.arguments[index]), parameter_(parameter) {
    bound_.name = declared.name.empty() ? parameter.name : declared.name;
    subject_ = fmt::format("argument {} '{}'", index, bound_.name);
    declared_type_ = declared.type;
  }

  BoundArgument bind() && {
    switch (kind()) {
      case KernelArgument::Kind::local:
        bind_local();
        break;
      case KernelArgument::Kind::buffer:
        find_type();
        bound_.buffer = DeviceBuffer(given_.size);
        fill(bound_.buffer.bytes());
        bound_.argument = KernelArgument::buffer(bound_.buffer.bytes());
        bound_.argument.vector_bytes = vector_bytes_of_parameter(declared_type_);
        bound_.argument.read_only = given_.read_only;
        bound_.argument.write_only = given_.write_only;
        bound_.argument.uninitialized = given_.no_init;
        break;
      case KernelArgument::Kind::scalar:
        bind_scalar();
        break;
    }
    bound_.argument.name = bound_.name;
    return std::move(bound_);
  }

 private:
  [[noreturn]] void refuse(std::string_view what, std::string_view expected) const {
    refuse(given_.line, what, expected);
  }
  [[noreturn]] void refuse(int line, std::string_view what, std::string_view expected) const {
    throw_input_error(fmt::format("{}:{}", path_, line), fmt::format("{}: {}", subject_, what), expected);
  }

  KernelArgument::Kind kind() const {
    if (parameter_.pointer == Pointer::shared) return KernelArgument::Kind::local;
    if (parameter_.pointer != Pointer::none) return KernelArgument::Kind::buffer;
    const bool as_buffer = given_.is_null || given_.no_init || !given_.range.empty() ||
                           !given_.file.empty() || given_.read_only || given_.write_only || given_.dump ||
                           given_.size != parameter_.bytes;
    const bool may_be_pointer = parameter_.bytes == 8 && declared_type_.empty();
    return as_buffer && may_be_pointer ? KernelArgument::Kind::buffer : KernelArgument::Kind::scalar;
  }

  bool has_data() const {
    return given_.no_init || !given_.fill.empty() || !given_.range.empty() || !given_.file.empty() ||
           !given_.values.empty();
  }

  void bind_local() {
    if (given_.is_null || given_.dump || has_data()) refuse("data for local memory", "a size alone");
    bound_.argument = KernelArgument::local(static_cast<std::uint32_t>(given_.size));
  }

  // Its three elements without the fourth's room behind them.
  bool is_tight_3_vector() const {
    const auto type = element_type_of_parameter(declared_type_);
    const bool has_three = declared_type_.ends_with('3') || declared_type_.ends_with("(3)))");
    return type && has_three && given_.size == 3 * element_size(*type);
  }

  void bind_scalar() {
    if (given_.is_null || given_.dump || given_.no_init || given_.read_only || given_.write_only)
      refuse("null, noinit, dump, ro or wo for a scalar", "a buffer parameter for these");
    if (given_.size != parameter_.bytes && !is_tight_3_vector())
      refuse(fmt::format("size={}", given_.size),
             fmt::format("size={}, as the kernel declares it", parameter_.bytes));
    find_type();
    std::vector<std::byte> value(parameter_.bytes);
    fill(std::span(value).first(given_.size));
    bound_.argument = KernelArgument::scalar(value);
  }

  // That of the file, else that of the source, else, where bytes need none, uchar.
  void find_type() {
    if (given_.type) {
      bound_.type = *given_.type;
    } else if (const auto type = element_type_of_parameter(declared_type_)) {
      bound_.type = *type;
    } else if (!given_.fill.empty() || !given_.range.empty() || !given_.values.empty()) {
      refuse(declared_type_.empty() ? "values without a type"
                                    : fmt::format("values for the type '{}'", declared_type_),
             fmt::format("a type ({}) in the argument", fmt::join(element_names(), ", ")));
    }
    const std::size_t size = element_size(bound_.type);
    if (given_.size % size != 0)
      refuse(fmt::format("size={}", given_.size),
             fmt::format("a multiple of {}, the size of {}", size, element_name(bound_.type)));
  }

  void fill(std::span<std::byte> to) const {
    if (given_.is_null || given_.no_init) return;
    if (!given_.fill.empty()) {
      fill_constant(to);
    } else if (!given_.range.empty()) {
      fill_with_range(to);
    } else if (!given_.file.empty()) {
      fill_from_file(to);
    } else {
      fill_with_values(to);
    }
  }

  void read_value(std::string_view text, int line, std::byte* to) const {
    if (!read_element(bound_.type, text, given_.hex, to))
      refuse(
          line, fmt::format("'{}'", text),
          fmt::format("a value of type {}{}", element_name(bound_.type), given_.hex ? ", hexadecimal" : ""));
  }

  void fill_constant(std::span<std::byte> to) const {
    const std::size_t size = element_size(bound_.type);
    for (std::size_t at = 0; at < to.size(); at += size) {
      if (at == 0) {
        read_value(given_.fill, given_.line, to.data());
      } else {
        std::copy_n(to.data(), size, to.data() + at);
      }
    }
  }

  void fill_with_range(std::span<std::byte> to) const {
    const std::size_t size = element_size(bound_.type);
    std::array<std::byte, 3 * sizeof(double)> bounds;
    std::string_view text = given_.range;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t colon = i < 2 ? text.find(':') : text.size();
      if (colon == std::string_view::npos)
        refuse(fmt::format("'range={}'", given_.range), "range=BEGIN:STEP:END");
      read_value(text.substr(0, colon), given_.line, bounds.data() + i * size);
      text.remove_prefix(std::min(colon + 1, text.size()));
    }
    if (!fill_range(bound_.type, std::span(bounds).first(3 * size), to))
      refuse(fmt::format("'range={}'", given_.range),
             fmt::format("steps that reach the end after {} values", to.size() / size));
  }

  void fill_from_file(std::span<std::byte> to) const {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(given_.file, error);
    std::ifstream in(given_.file, std::ios::binary);
    if (error || !in) refuse(fmt::format("'{}' cannot be read", given_.file.string()), "a file");
    if (size != to.size())
      refuse(fmt::format("'{}' has {} bytes", given_.file.string(), size),
             fmt::format("{} bytes", to.size()));
    in.read(reinterpret_cast<char*>(to.data()), static_cast<std::streamsize>(to.size()));
    if (!in) refuse(fmt::format("'{}' cannot be read", given_.file.string()), "a file");
  }

  void fill_with_values(std::span<std::byte> to) const {
    const std::size_t size = element_size(bound_.type), n = to.size() / size;
    if (given_.values.size() != n)
      refuse(fmt::format("{} values", given_.values.size()),
             fmt::format("{} of type {}, or one of fill=, range=, file= and noinit", n,
                         element_name(bound_.type)));
    for (std::size_t i = 0; i < n; ++i)
      read_value(given_.values[i].text, given_.values[i].line, to.data() + i * size);
  }

  std::string path_;
  const LaunchFileArgument& given_;
  const KernelParameter& parameter_;
  std::string subject_, declared_type_;
  BoundArgument bound_;
};

}  // namespace

std::vector<BoundArgument> bind_arguments(const LaunchFile& file, std::span<const KernelParameter> parameters,
                                          std::span<const ParameterDeclaration> declared) {
  if (file.arguments.size() != parameters.size()) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      names.push_back(i < declared.size() ? declared[i].name : parameters[i].name);
    const std::size_t n = file.arguments.size();
    const int line = n > parameters.size() ? file.arguments[parameters.size()].line
                                           : (n == 0 ? 1 : file.arguments[n - 1].line);
    throw_input_error(fmt::format("{}:{}", file.path.string(), line),
                      fmt::format("{} arguments for kernel '{}'", n, file.kernel),
                      fmt::format("{}: {}", parameters.size(), fmt::join(names, ", ")));
  }
  std::vector<BoundArgument> bound;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    bound.push_back(
        Binder(file, i, parameters[i], i < declared.size() ? declared[i] : ParameterDeclaration{}).bind());
  return bound;
}

void dump_arguments(const LaunchFile& file, std::span<const BoundArgument> bound, std::ostream& out) {
  for (std::size_t i = 0; i < bound.size(); ++i) {
    if (!file.arguments[i].dump) continue;
    const std::span<const std::byte> data = bound[i].buffer.bytes();
    out << "\nArgument '" << bound[i].name << "': " << data.size() << " bytes\n";
    dump_elements(bound[i].type, bound[i].name, data, file.arguments[i].hex, out);
    out << '\n';
  }
}

}  // namespace warpgrain::profiler
