#include "profiler/ptx/declaration_parser.hpp"

#include <bit>
#include <cstring>
#include <fmt/format.h>

namespace warpgrain::profiler::ptx {
namespace {

// What stands before the declared names: alignment, vector width, type.
struct Attributes {
  std::uint32_t alignment = 0;  // 0: the type's own
  std::uint32_t vector_width = 1;
  std::optional<ScalarType> type;
  KernelParameter::Pointer pointer = KernelParameter::Pointer::none;
};

KernelParameter::Pointer pointer_into(std::optional<StateSpace> space) {
  switch (space.value_or(StateSpace::generic)) {
    case StateSpace::shared:
      return KernelParameter::Pointer::shared;
    case StateSpace::constant:
      return KernelParameter::Pointer::constant;
    case StateSpace::global:
      return KernelParameter::Pointer::global;
    default:
      return KernelParameter::Pointer::none;
  }
}

std::uint32_t parse_alignment(TokenCursor& cursor) {
  const std::uint64_t alignment = cursor.expect_integer("an alignment");
  if (!std::has_single_bit(alignment) || alignment > 4096)
    cursor.refuse(fmt::format("alignment {}", alignment), "a power of two");
  return static_cast<std::uint32_t>(alignment);
}

// `.ptr .global .align 4`: the alignment is that of what is pointed at.
void parse_pointer(TokenCursor& cursor, Attributes& attributes) {
  if (cursor.peek().kind == Token::Kind::directive) {
    if (const auto space = state_space(cursor.peek().text)) {
      attributes.pointer = pointer_into(space);
      cursor.take();
    }
  }
  if (cursor.take_if_directive("align")) parse_alignment(cursor);
}

Attributes parse_attributes(TokenCursor& cursor) {
  Attributes attributes;
  while (cursor.peek().kind == Token::Kind::directive) {
    const std::string_view name = cursor.peek().text;
    if (const auto type = scalar_type(name)) {
      attributes.type = type;
      cursor.take();
    } else if (cursor.take_if_directive("align")) {
      attributes.alignment = parse_alignment(cursor);
    } else if (name == "v2" || name == "v4") {
      attributes.vector_width = name == "v2" ? 2 : 4;
      cursor.take();
    } else if (name == "texref" || name == "samplerref" || name == "surfref") {
      attributes.type = bits_type(64);  // a handle
      cursor.take();
    } else if (cursor.take_if_directive("attribute")) {
      cursor.skip_behind(')');  // of memory that a host may reach
    } else if (cursor.take_if_directive("ptr")) {
      parse_pointer(cursor, attributes);
    } else {
      cursor.refuse_next("a type, .align, .v2 or .v4");
    }
  }
  if (!attributes.type) cursor.refuse_next("a type");
  return attributes;
}

class Declarator {
 public:
  Declarator(TokenCursor& cursor, const Attributes& attributes, StateSpace space)
      : cursor_(cursor), attributes_(attributes) {
    variable_.line = cursor.peek().line;
    variable_.space = space;
    variable_.type = *attributes.type;
    variable_.pointer = attributes.pointer;
    variable_.alignment =
        attributes.alignment ? attributes.alignment : variable_.type.bytes() * attributes.vector_width;
  }

  Variable parse() {
    variable_.name = cursor_.expect_name("a name");
    while (cursor_.take_if('[')) {
      extents_.push_back(cursor_.peek().is(']') ? 0 : cursor_.expect_integer("an array's extent"));
      cursor_.expect(']');
    }
    const bool unsized = !extents_.empty() && extents_.front() == 0;
    if (attributes_.vector_width > 1) extents_.push_back(attributes_.vector_width);
    variable_.bytes = variable_.type.bytes();
    for (const std::uint64_t extent : extents_)
      if (__builtin_mul_overflow(variable_.bytes, extent, &variable_.bytes) || variable_.bytes > max_bytes)
        cursor_.refuse(fmt::format("array '{}'", variable_.name), fmt::format("at most {} bytes", max_bytes));
    if (cursor_.take_if('=')) {
      if (unsized) cursor_.refuse(fmt::format("array '{}' without an extent", variable_.name), "its extent");
      variable_.initial.assign(variable_.bytes, 0);
      parse_initial(0, 0);
    }
    return variable_;
  }

 private:
  static constexpr std::uint64_t max_bytes = std::uint64_t{1} << 32;

  // Elements at `offset`; a brace list holds those of one dimension.
  void parse_initial(std::uint64_t offset, std::size_t dimension) {
    if (!cursor_.take_if('{')) return parse_element(offset);
    std::uint64_t stride = variable_.type.bytes();
    // In a list of plain elements, which may run through all inner dimensions, the stride is one element.
    if (cursor_.peek().is('{'))
      for (std::size_t d = dimension + 1; d < extents_.size(); ++d) stride *= extents_[d];
    while (!cursor_.take_if('}')) {
      parse_initial(offset, dimension + 1);
      offset += stride;
      if (!cursor_.peek().is('}')) cursor_.expect(',');
    }
  }

  void parse_element(std::uint64_t offset) {
    if (offset + variable_.type.bytes() > variable_.bytes)
      cursor_.refuse(fmt::format("too many initial values for '{}'", variable_.name),
                     fmt::format("{} bytes of them", variable_.bytes));
    const Token& token = cursor_.peek();
    if (token.kind == Token::Kind::identifier) return parse_address(offset);
    std::uint64_t value = 0;
    if (token.kind == Token::Kind::float32 || token.kind == Token::Kind::float64)
      value = float_bits(cursor_.take());
    else
      value = cursor_.expect_signed_integer("an initial value");
    std::memcpy(&variable_.initial[offset], &value, variable_.type.bytes());
  }

  std::uint64_t float_bits(const Token& token) const {
    const bool is_single = token.kind == Token::Kind::float32;
    if (variable_.type.bits == (is_single ? 32 : 64)) return token.value;
    const double value = is_single ? std::bit_cast<float>(static_cast<std::uint32_t>(token.value))
                                   : std::bit_cast<double>(token.value);
    if (variable_.type.bits == 32) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    if (variable_.type.bits == 64) return std::bit_cast<std::uint64_t>(value);
    cursor_.refuse(fmt::format("'{}'", token.text), "an integer");
  }

  // `symbol`, `symbol+8`, `generic(symbol)+8`
  void parse_address(std::uint64_t offset) {
    Relocation relocation;
    relocation.offset = offset;
    relocation.symbol = cursor_.expect_name("a symbol");
    if (relocation.symbol == "generic" && cursor_.take_if('(')) {
      relocation.symbol = cursor_.expect_name("a symbol");
      cursor_.expect(')');
    }
    if (cursor_.take_if('+')) relocation.addend = cursor_.expect_signed_integer("an offset");
    if (variable_.type.bits != 64)
      cursor_.refuse(fmt::format("the address of '{}'", relocation.symbol), "64-bit elements");
    variable_.relocations.push_back(relocation);
  }

  TokenCursor& cursor_;
  const Attributes& attributes_;
  Variable variable_;
  std::vector<std::uint64_t> extents_;
};

}  // namespace

std::vector<Variable> parse_variables(TokenCursor& cursor, StateSpace space) {
  const Attributes attributes = parse_attributes(cursor);
  std::vector<Variable> variables;
  do {
    variables.push_back(Declarator(cursor, attributes, space).parse());
  } while (cursor.take_if(','));
  cursor.expect(';');
  return variables;
}

std::vector<Variable> parse_parameters(TokenCursor& cursor) {
  std::vector<Variable> parameters;
  cursor.expect('(');
  while (!cursor.take_if(')')) {
    if (!cursor.take_if_directive("param")) cursor.refuse_next("'.param'");
    const Attributes attributes = parse_attributes(cursor);
    parameters.push_back(Declarator(cursor, attributes, StateSpace::parameter).parse());
    if (!cursor.peek().is(')')) cursor.expect(',');
  }
  return parameters;
}

}  // namespace warpgrain::profiler::ptx
