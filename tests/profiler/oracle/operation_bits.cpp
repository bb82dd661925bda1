// Logic, shifts, bit fields and bit counts.

#include <bit>
#include <type_traits>

#include "tests/profiler/oracle/operation.hpp"

namespace warpgrain::oracle {
namespace {

constexpr ptx::ScalarType u32{ptx::ScalarType::Kind::unsigned_integer, 32};

Bits mask_of(unsigned bits) { return bits >= 64 ? ~Bits{0} : (Bits{1} << bits) - 1; }

Operation logic(const ptx::Statement& s, ptx::ScalarType type) {
  const Bits mask = mask_of(type.bits);
  const auto binary = [&](auto function) {
    return Operation{
        {type, type}, type, [function, mask](const Bits* in) { return function(in[0], in[1]) & mask; }};
  };
  if (s.opcode == "and") return binary([](Bits a, Bits b) { return a & b; });
  if (s.opcode == "or") return binary([](Bits a, Bits b) { return a | b; });
  if (s.opcode == "xor") return binary([](Bits a, Bits b) { return a ^ b; });
  return {{type}, type, [mask](const Bits* in) { return ~in[0] & mask; }};
}

// Amounts above the width are clamped to it.
Operation shift(const ptx::Statement& s, ptx::ScalarType type) {
  return with_integer(s, type, [&](auto sample) {
    using T = decltype(sample);
    const bool left = s.opcode == "shl";
    return Operation{{type, u32}, type, [left](const Bits* in) -> Bits {
                       constexpr unsigned width = 8 * sizeof(T);
                       const T value = value_of<T>(in[0]);
                       if (left) return in[1] >= width ? 0 : bits_of<T>(static_cast<T>(in[0] << in[1]));
                       if (in[1] >= width) return bits_of<T>(value < 0 ? static_cast<T>(-1) : T{0});
                       return bits_of<T>(static_cast<T>(value >> in[1]));
                     }};
  });
}

// shf: 32 bits out of the 64 of (high, low), moved by an amount that wraps at 32 or is clamped to it.
Operation funnel_shift(const ptx::Statement& s, Modifiers& modifiers, ptx::ScalarType type) {
  const bool left = modifiers.take("l"), right = modifiers.take("r");
  const bool wraps = modifiers.take("wrap"), clamps = modifiers.take("clamp");
  if (left == right || wraps == clamps) refuse(s, "a direction and a mode are expected");
  return {{type, type, u32}, type, [left, wraps](const Bits* in) {
            const Bits amount = wraps ? in[2] % 32 : std::min<Bits>(in[2], 32);
            const Bits both = in[1] << 32 | in[0];
            return (left ? both << amount >> 32 : both >> amount) & mask_of(32);
          }};
}

Operation count_of(const ptx::Statement& s, ptx::ScalarType type) {
  const bool wide = type.bits == 64;
  if (s.opcode == "popc")
    return {{type}, u32, [](const Bits* in) { return static_cast<Bits>(std::popcount(in[0])); }};
  return {{type}, u32, [wide](const Bits* in) {
            return static_cast<Bits>(std::countl_zero(in[0]) - (wide ? 0 : 32));
          }};
}

Operation reversed(ptx::ScalarType type) {
  const unsigned width = type.bits;
  return {{type}, type, [width](const Bits* in) {
            Bits result = 0;
            for (unsigned i = 0; i < width; ++i) result |= (in[0] >> i & 1) << (width - 1 - i);
            return result;
          }};
}

// bfe: `in[2]` bits from bit `in[1]` on; beyond the top, a signed field repeats its sign bit.
Operation field_of(ptx::ScalarType type) {
  const unsigned width = type.bits;
  const bool is_signed = type.is_signed();
  return {{type, u32, u32}, type, [width, is_signed](const Bits* in) {
            const Bits position = in[1] & 0xff, length = in[2] & 0xff;
            if (length == 0) return Bits{0};
            const Bits top = std::min<Bits>(position + length - 1, width - 1);
            const Bits sign = is_signed ? in[0] >> top & 1 : 0;
            Bits result = 0;
            for (Bits i = 0; i < width; ++i) {
              const bool inside = i < length && position + i < width;
              result |= (inside ? in[0] >> (position + i) & 1 : sign) << i;
            }
            return result;
          }};
}

// bfi: the low bits of a put into b.
Operation insertion(ptx::ScalarType type) {
  const unsigned width = type.bits;
  return {{type, type, u32, u32}, type, [width](const Bits* in) {
            Bits result = in[1];
            for (Bits i = 0; i < (in[3] & 0xff) && (in[2] & 0xff) + i < width; ++i) {
              const Bits at = (in[2] & 0xff) + i;
              result = (result & ~(Bits{1} << at)) | (in[0] >> i & 1) << at;
            }
            return result;
          }};
}

// prmt: each byte of the result is one of the eight of (b, a), or eight times its sign.
Operation permutation(ptx::ScalarType type) {
  return {{type, type, u32}, type, [](const Bits* in) {
            const Bits bytes = in[1] << 32 | in[0];
            Bits result = 0;
            for (unsigned i = 0; i < 4; ++i) {
              const Bits choice = in[2] >> (4 * i) & 0xf;
              Bits byte = bytes >> (8 * (choice & 7)) & 0xff;
              if ((choice & 8) != 0) byte = (byte & 0x80) != 0 ? 0xff : 0;
              result |= byte << (8 * i);
            }
            return result;
          }};
}

}  // namespace

Operation bit_operation(const ptx::Statement& statement) {
  static constexpr const char* known[] = {"and", "or",   "xor", "not", "shl",  "shr", "popc",
                                          "clz", "brev", "bfe", "bfi", "prmt", "shf"};
  const std::string& name = statement.opcode;
  if (std::find(std::begin(known), std::end(known), name) == std::end(known)) return {};
  Modifiers modifiers(statement);
  const ptx::ScalarType type = modifiers.take_type();
  Operation operation;
  if (name == "shl" || name == "shr") {
    operation = shift(statement, type);
  } else if (name == "popc" || name == "clz") {
    operation = count_of(statement, type);
  } else if (name == "brev") {
    operation = reversed(type);
  } else if (name == "bfe") {
    operation = field_of(type);
  } else if (name == "bfi") {
    operation = insertion(type);
  } else if (name == "prmt") {
    operation = permutation(type);
  } else if (name == "shf") {
    operation = funnel_shift(statement, modifiers, type);
  } else {
    operation = logic(statement, type);
  }
  modifiers.finish();
  return operation;
}

}  // namespace warpgrain::oracle
