#include "profiler/constant_padding.hpp"
#include "tests/profiler/against_pocl.hpp"

namespace warpgrain::profiler {
namespace {

// Whatever follows a 3-vector in an initialised variable: another one, a member of its struct, the next
// struct. The index comes from memory, so that the compiler cannot look the value up.
TEST(ConstantPadding, InitialValuesStandWhereTheyAreRead) {
  for (const std::string type : {"char", "ushort", "uint", "long", "float", "double"})
    expect_same(
        "#pragma OPENCL EXTENSION cl_khr_fp64 : enable\n#define T " + type + "\n#define T3 " + type + R"(3
struct Part { char before; T3 inner[2]; char after; };
constant T3 alone = (T3)(1, 2, 3);
constant T3 row[3] = {(T3)(1, 2, 3), (T3)(4, 5, 6), (T3)(7, 8, 9)};
constant T3 zeros_first[2] = {(T3)(0), (T3)(4, 5, 6)};
constant struct Part parts[2] = {{1, {(T3)(2, 3, 4), (T3)(5, 6, 7)}, 8}, {9, {(T3)(10, 11, 12)}, 13}};
kernel void k(global const uint* in, global uint* out) {
  const uint i = get_global_id(0), j = in[i] % 3, h = in[i] & 1;
  T3 own[3] = {(T3)(20, 21, 22), (T3)(23, 24, 25), (T3)(26, 27, 28)};
  own[h].y += 1;
  global uint* o = out + 16 * i;
  o[0] = (uint)row[j].x + (uint)row[j].z * 16u;
  o[1] = (uint)zeros_first[h].y;
  o[2] = parts[h].before, o[3] = (uint)parts[h].inner[1].x, o[4] = (uint)parts[h].inner[0].z, o[5] = parts[h].after;
  o[6] = (uint)own[j].y, o[7] = (uint)alone.z;
})",
        line_of(64, 32));
}

TEST(ConstantPadding, RefusesWhatIsNoBitcode) {
  EXPECT_THROW(pad_vectors_of_three("no bitcode"), std::runtime_error);
}

}  // namespace
}  // namespace warpgrain::profiler
