#include "tests/profiler/oracle/random_kernel.hpp"
#include "tests/profiler/oracle/random_text.hpp"

namespace warpgrain::oracle {
namespace {

// Registers: %r0 to %r5 hold data; %r6 is fuel, %r7 to %r9 scratch; %p0 to %p2 are for conditions. %rd0 is
// the input, %rd1 the lane's part of the output, %rd2 the sums, %rd3 and %rd4 scratch.
constexpr const char* registers = ".reg .pred %p<4>; .reg .b32 %r<10>; .reg .b64 %rd<5>;\n";

class PtxWriter {
 public:
  explicit PtxWriter(std::uint64_t seed) : dice_(seed), seed_(std::to_string(seed)) {}

  RandomKernel write() {
    RandomKernel kernel;
    kernel.seed = std::stoull(seed_);
    kernel.name = fill("k$", {seed_});
    kernel.shape = dice_.one_in(2) ? profiler::LaunchShape{{96, 1, 1}, {48, 1, 1}}
                                   : profiler::LaunchShape{{64, 1, 1}, {64, 1, 1}};
    const std::string called = dice_.one_in(2) ? function() : "";
    calls_ = !called.empty();
    kernel.source = fill(".version 7.5\n.target sm_70\n.address_size 64\n$$", {called, entry(kernel.name)});
    return kernel;
  }

 private:
  std::string data() { return fill("%r$", {dice_.number_below(6)}); }
  std::string number() { return dice_.one_in(2) ? data() : dice_.number_below(100); }
  std::string predicate() { return fill("%p$", {dice_.number_below(3)}); }
  std::string guard() { return fill(dice_.one_in(2) ? "@$ " : "@!$ ", {predicate()}); }

  std::string condition() {
    const std::string target = predicate();
    return dice_.one_in(2)
               ? fill("and.b32 %r7, $, $; setp.eq.u32 $, %r7, $;\n",
                      {data(), dice_.one_of({"1", "3", "5", "7"}), target, dice_.number_below(3)})
               : fill("setp.$.u32 $, $, $;\n", {dice_.one_of({"lt", "ge", "ne"}), target, data(), number()});
  }

  // Accesses of own words, of the input, and sums that commute; some of them predicated.
  std::string instruction(bool in_function) {
    const std::string when = dice_.one_in(3) ? guard() : "";
    switch (dice_.below(in_function ? 4 : 9)) {
      case 0:
      case 1:
        return fill(
            "$$ $, $, $;\n",
            {when,
             dice_.one_of({"add.s32", "sub.s32", "mul.lo.s32", "xor.b32", "and.b32", "shr.u32", "min.u32"}),
             data(), data(), number()});
      case 2:
      case 3:
        return condition();
      case 4:
        return fill("and.b32 %r7, $, 63; mad.wide.u32 %rd3, %r7, 4, %rd0;\n$ld.global.u32 $, [%rd3];\n",
                    {data(), when, data()});
      case 5:
        return fill(
            "and.b32 %r7, $, 31; mad.wide.u32 %rd3, %r7, 8, %rd0;\n$ld.global.v2.u32 {%r4, %r5}, [%rd3];\n",
            {data(), when});
      case 6:
        return fill("and.b32 %r7, $, 3; mad.wide.u32 %rd3, %r7, 4, %rd1;\n$st.global.u32 [%rd3], $;\n",
                    {data(), when, data()});
      case 7:
        return fill("$red.global.add.u32 [%rd2+$], $;\n", {when, dice_.one_of({"0", "4"}), data()});
      default:
        return calls_ ? call() : condition();
    }
  }

  std::string call() {
    return fill(
        "{\n.param .b32 argument;\nst.param.b32 [argument+0], $;\n.param .b32 result;\ncall.uni (result), "
        "f$, "
        "(argument);\nld.param.b32 $, [result+0];\n}\n",
        {data(), seed_, data()});
  }

  std::string label(std::uint64_t block) { return fill("B$", {std::to_string(block)}); }

  // How a block ends. Ways back cost fuel, and without it lead on.
  std::string end(std::uint64_t block, std::uint64_t n_blocks, const std::string& leave) {
    const auto ahead = [&] { return label(block + 1 + dice_.below(n_blocks - block)); };
    switch (dice_.below(9)) {
      case 0:
        return "";
      case 1:
        return fill("$bra $;\n", {guard(), label(block + 1)});  // both ways lead there
      case 2:
        return fill("bra.uni $;\n", {ahead()});
      case 3:
        return fill("$$;\n", {guard(), leave});
      case 4: {
        const std::string back = label(dice_.below(block + 1));
        return fill(
            "sub.s32 %r6, %r6, 1; setp.gt.s32 %p3, %r6, 0; selp.u32 %r7, $, 0, %p3; and.b32 %r7, %r7, 3;\n"
            "T$: .branchtargets $, $, $, $;\nbrx.idx %r7, T$;\n",
            {data(), std::to_string(block), ahead(), back, ahead(), dice_.one_in(2) ? back : ahead(),
             std::to_string(block)});
      }
      case 5:
      case 6:
        return fill("sub.s32 %r6, %r6, 1; setp.gt.and.s32 %p3, %r6, 0, $;\n@%p3 bra $;\n",
                    {predicate(), label(dice_.below(block + 1))});
      default:
        return fill("$bra $;\n", {guard(), ahead()});
    }
  }

  std::string blocks(std::uint64_t n_blocks, bool in_function, const std::string& leave) {
    std::string text;
    for (std::uint64_t block = 0; block < n_blocks; ++block) {
      text += fill("$:\n", {label(block)});
      for (auto n = dice_.below(4); n > 0; --n) text += instruction(in_function);
      text += end(block, n_blocks, leave);
    }
    return text + fill("$:\n", {label(n_blocks)});
  }

  std::string function() {
    return fill(
        ".func (.param .b32 result) f$(.param .b32 argument)\n{\n$ld.param.u32 %r0, [argument]; mov.u32 %r6, "
        "4;\n"
        "add.s32 %r1, %r0, 7; mul.lo.s32 %r2, %r0, 5; shr.u32 %r3, %r0, 3;\nst.param.b32 [result+0], %r1;\n$"
        "st.param.b32 [result+0], %r2;\nret;\n}\n",
        {seed_, registers, blocks(2 + dice_.below(5), true, "ret")});
  }

  std::string entry(const std::string& name) {
    return fill(
        ".visible .entry $(.param .u64 .ptr .global in, .param .u64 .ptr .global out, .param .u64 .ptr "
        ".global sums, "
        ".param .u32 n)\n{\n$"
        "ld.param.u64 %rd0, [in]; ld.param.u64 %rd1, [out]; ld.param.u64 %rd2, [sums];\n"
        "mov.u32 %r7, %ctaid.x; mov.u32 %r8, %ntid.x; mov.u32 %r9, %tid.x; mad.lo.s32 %r0, %r7, %r8, %r9;\n"
        "mad.wide.u32 %rd1, %r0, 16, %rd1; and.b32 %r7, %r0, 63; mad.wide.u32 %rd3, %r7, 4, %rd0;\n"
        "ld.global.u32 %r1, [%rd3]; shr.u32 %r2, %r1, 3; xor.b32 %r3, %r1, %r0; mov.u32 %r4, %tid.x; mov.u32 "
        "%r5, 9;\n"
        "mov.u32 %r6, $;\n$$$"
        "st.global.v4.u32 [%rd1], {%r0, %r1, %r2, %r3};\nret;\n}\n",
        {name, registers, std::to_string(2 + dice_.below(14)), condition(), condition(),
         blocks(3 + dice_.below(14), false, dice_.one_in(2) ? "ret" : "exit")});
  }

  Dice dice_;
  std::string seed_;
  bool calls_ = false;
};

}  // namespace

RandomKernel random_ptx_kernel(std::uint64_t seed) { return PtxWriter(seed).write(); }

}  // namespace warpgrain::oracle
