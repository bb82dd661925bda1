#pragma once
// What a checked launch found wrong with its kernel.
//
//   kernel.cl:3 (PTX line 41): out_of_bounds: store of 4 bytes to global buffer 'out' at byte 256 of 256,
//   work-item (64, 0, 0) in work-group (2, 0, 0); 64 times

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace warpgrain::profiler {

enum class DiagnosticKind : std::uint8_t {
  out_of_bounds,       // no byte of any buffer, or not all bytes of the one meant
  null_pointer,        // through a null buffer, or an address below the first page
  misaligned,          // the address is no multiple of the access's size
  read_only_write,     // to constant memory, or a buffer that is `ro`
  write_only_read,     // from a buffer that is `wo`
  uninitialized_read,  // bytes of a `noinit` buffer or of local memory that nobody has written
  data_race,           // two work-items touch the same bytes, one writes, and no barrier is between
  subvector_race,      // the same of two components of one vector, which a compiler may store as a whole
  barrier_divergence,  // not every work-item of the group came to the barrier
  trap,                // a work-item ran a trap
  invalid_call,        // it called through a pointer to no function
  endless_loop,        // a loop that nothing leaves
  instruction_limit,   // a work-item ran more instructions than it may
  trace_limit,         // a work-group left longer traces than fit
  count
};
std::string_view diagnostic_kind_name(DiagnosticKind kind);  // as in reports: "out_of_bounds"

struct DiagnosticPlace {
  std::string file;  // "": the compiler gave none
  std::uint32_t line = 0;
  std::uint32_t ptx_line = 0;
  bool operator==(const DiagnosticPlace&) const = default;
};

// The earlier access that the one at hand races with.
struct OtherAccess {
  DiagnosticPlace place;
  std::string access;  // "load", "store", "atomic"
  std::optional<std::array<std::uint64_t, 3>> work_item;
  bool operator==(const OtherAccess&) const = default;
};

// One kind at one place. Of its repeats the one of the lowest work-item is told.
struct Diagnostic {
  DiagnosticKind kind = DiagnosticKind::out_of_bounds;
  DiagnosticPlace place;
  std::array<std::uint64_t, 3> work_item{};   // global id
  std::array<std::uint64_t, 3> work_group{};  // group id
  std::string access;                         // as OtherAccess::access; "" where no memory is touched
  std::string space;                          // "global", "shared", ...
  std::uint32_t bytes = 0;                    // of the access
  std::string buffer;                         // argument or variable; "" where the address belongs to none
  std::int64_t offset = 0;                    // bytes from the buffer's start
  std::uint64_t buffer_bytes = 0;
  std::string detail;  // more, in words; may be empty
  std::optional<OtherAccess> other;
  std::uint64_t count = 1;
  bool operator==(const Diagnostic&) const = default;
};

// "kernel.cl:3 (PTX line 41)", or "PTX line 41" without a line table.
std::string place_text(const DiagnosticPlace& place);
// One line, as above.
std::string diagnostic_text(const Diagnostic& diagnostic);

}  // namespace warpgrain::profiler
