#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/ptx/parser.hpp"
#include "tests/profiler/ptx_text.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Module parse_text(std::string_view rest) { return parse(ptx_module(rest), "m.ptx"); }

TEST(Parser, Variables) {
  const Module module = parse_text(R"(
.visible .const .align 16 .b8 bytes[4] = {1, 2, 0xff};
.const .u32 grid[2][3] = {{1, 2}, {3}};
.global .f32 floats[2] = {0f3F800000, 2.5};
.global .v2 .s16 pair = {-1, 7};
.global .u64 places[2] = {generic(bytes)+2, floats};
.extern .shared .align 4 .b8 dynamic[];
.global .u32 first, second = 9;
)");
  ASSERT_EQ(module.variables.size(), 8u);
  const Variable& bytes = *module.find_variable("bytes");
  EXPECT_EQ(bytes.space, StateSpace::constant);
  EXPECT_EQ(bytes.alignment, 16u);
  EXPECT_THAT(bytes.initial, ElementsAre(1, 2, 255, 0));
  const Variable& grid = *module.find_variable("grid");
  EXPECT_EQ(grid.bytes, 24u);
  EXPECT_THAT(grid.initial,
              ElementsAre(1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(module.find_variable("floats")->initial, ElementsAre(0, 0, 0x80, 0x3f, 0, 0, 0x20, 0x40));
  EXPECT_THAT(module.find_variable("pair")->initial, ElementsAre(255, 255, 7, 0));
  const Variable& places = *module.find_variable("places");
  ASSERT_EQ(places.relocations.size(), 2u);
  EXPECT_EQ(places.relocations[0].symbol, "bytes");
  EXPECT_EQ(places.relocations[0].addend, 2u);
  EXPECT_EQ(places.relocations[1].offset, 8u);
  EXPECT_TRUE(module.find_variable("dynamic")->external);
  EXPECT_EQ(module.find_variable("second")->bytes, 4u);
}

TEST(Parser, SignaturesAndDeclarations) {
  const Module module = parse_text(R"(
.visible .entry kernel_name(
  .param .u64 .ptr .global .align 16 a, .param .u64 .ptr .shared .align 4 b, .param .u64 .ptr .const .align 4 c,
  .param .align 16 .b8 d[32], .param .u8 e
)
.maxntid 256, 1, 1
.reqntid 64, 2
{
  .reg .pred %p<3>; .reg .b32 %r<2>, %extra;
  .local .align 8 .b8 depot[24];
  .shared .align 4 .f32 tile[8];
  ret;
}
.extern .func (.param .b32 result) helper(.param .b32 x, .param .b64 y);
.func plain() { ret; }
)");
  const Function& kernel = *module.find_entry("kernel_name");
  ASSERT_EQ(kernel.parameters.size(), 5u);
  using Pointer = KernelParameter::Pointer;
  EXPECT_EQ(kernel.parameters[0].pointer, Pointer::global);
  EXPECT_EQ(kernel.parameters[0].alignment, 8u);
  EXPECT_EQ(kernel.parameters[1].pointer, Pointer::shared);
  EXPECT_EQ(kernel.parameters[2].pointer, Pointer::constant);
  EXPECT_EQ(kernel.parameters[3].bytes, 32u);
  EXPECT_EQ(kernel.parameters[3].alignment, 16u);
  EXPECT_EQ(kernel.parameters[4].bytes, 1u);
  EXPECT_EQ(kernel.registers.size(), 6u);
  EXPECT_EQ(kernel.registers[5].first, "%extra");
  ASSERT_EQ(kernel.variables.size(), 2u);
  EXPECT_EQ(kernel.variables[1].bytes, 32u);
  EXPECT_EQ(kernel.required_local_size, (std::array<std::uint32_t, 3>{64, 2, 1}));
  EXPECT_FALSE(module.find_function("helper")->has_body);
  EXPECT_EQ(module.find_function("helper")->results.size(), 1u);
  EXPECT_TRUE(module.find_function("plain")->has_body);
  EXPECT_EQ(module.find_entry("plain"), nullptr);
}

TEST(Parser, StatementsAndTheirOperands) {
  const Module module = parse_text(R"(
.entry k() {
  .reg .pred %p<4>; .reg .b32 %r<4>; .reg .b64 %rd<4>;
  .loc 1 7 3
$top:
  @!%p1 setp.lt.and.s32   %p0|%p2,
      %r0, -5, !%p3;
  .loc 2 30 5, function_name $L__info_string0+4, inlined_at 1 50 3
  ld.global.v2.u32 {%r1, _}, [%rd1+-8];
  mov.u32 %r2, %tid.x;
  st.shared.u32 [64], 0f3F800000;
  bra.uni $top;
}
.file 1 "." "dir/../a.cl"
.file 2 "b.h", 1234, 99
)");
  const Function& kernel = *module.find_entry("k");
  ASSERT_EQ(kernel.statements.size(), 5u);
  const Statement& compare = kernel.statements[0];
  EXPECT_EQ(compare.text, "@!%p1 setp.lt.and.s32 %p0|%p2, %r0, -5, !%p3;");
  EXPECT_EQ(compare.line, 9u);
  EXPECT_EQ(compare.location, (SourceLocation{1, 7}));
  EXPECT_EQ(compare.guard->predicate, "%p1");
  EXPECT_TRUE(compare.guard->negated);
  EXPECT_THAT(compare.modifiers, ElementsAre("lt", "and", "s32"));
  EXPECT_EQ(compare.operands[0].elements[1].name, "%p2");
  EXPECT_EQ(static_cast<std::int64_t>(compare.operands[2].value), -5);
  EXPECT_TRUE(compare.operands[3].negated);
  const Statement& load = kernel.statements[1];
  EXPECT_EQ(load.location, (SourceLocation{2, 30}));
  EXPECT_EQ(load.operands[0].elements.size(), 2u);
  EXPECT_EQ(load.operands[1].name, "%rd1");
  EXPECT_EQ(static_cast<std::int64_t>(load.operands[1].value), -8);
  EXPECT_EQ(kernel.statements[2].operands[1].name, "%tid.x");
  EXPECT_EQ(kernel.statements[3].operands[0].value, 64u);
  EXPECT_EQ(kernel.labels.at("$top"), 0u);
  EXPECT_EQ(module.files.at(1), "a.cl");
  EXPECT_EQ(module.files.at(2), "b.h");
}

TEST(Parser, InnerScopesHideOuterNames) {
  const Module module = parse_text(R"(.entry k() {
  .reg .b32 %a, %b;
  { .reg .b32 %a; mov.u32 %a, 1; mov.u32 %b, %a; }
  { .param .b32 param0; st.param.b32 [param0+0], %a; }
  { .param .b32 param0; st.param.b32 [param0+0], %b; }
  ret; })");
  const Function& kernel = *module.find_entry("k");
  EXPECT_EQ(kernel.registers.size(), 3u);
  EXPECT_EQ(kernel.statements[0].operands[0].name, kernel.registers[2].first);
  EXPECT_EQ(kernel.statements[1].operands[1].name, kernel.registers[2].first);
  EXPECT_EQ(kernel.statements[2].operands[1].name, "%a");
  EXPECT_NE(kernel.statements[2].operands[0].name, kernel.statements[3].operands[0].name);
}

TEST(Parser, DebugSectionsAndLabelsInsideCallsAreSkipped) {
  const Module module = parse_text(R"(.func f(.param .b32 x) { ret; }
.entry k() {
  { .param .b32 p0; st.param.b32 [p0], 1;
  call.uni
$L__tmp1:
  f, (
$L__tmp2:
  p0 );
  }
  ret; }
.section .debug_info { .b8 1 .b32 .Lx { } }
.section .debug_loc { }
)");
  const Function& kernel = *module.find_entry("k");
  ASSERT_EQ(kernel.statements.size(), 3u);
  EXPECT_EQ(kernel.statements[1].operands[0].name, "f");
}

TEST(Parser, RefusesByLine) {
  const auto refused = [](std::string_view rest) { return refusal([&] { parse_text(rest); }); };
  EXPECT_EQ(refusal([] { parse("kernel void k() {}", "k.cl"); }),
            "k.cl, PTX line 1: 'kernel'; expected '.version', which PTX begins with");
  EXPECT_EQ(refused(".entry k() { ret }"), "m.ptx, PTX line 4: '}'; expected an operand");
  EXPECT_THAT(refused(".entry k() { ret;"), HasSubstr("the body of 'k' opens here"));
  EXPECT_THAT(refused(".entry k() {\n.reg .b32 %r<99999999>; }"),
              HasSubstr("m.ptx, PTX line 5: 99999999 registers"));
  EXPECT_THAT(refused(".entry k() { .reg .b32 %a, %a; }"), HasSubstr("'%a' is declared twice"));
  EXPECT_THAT(refused(".entry k() { a: a: ret; }"), HasSubstr("label 'a' stands twice"));
  EXPECT_THAT(refused(".entry k(.param .u32 .align 3 x) { ret; }"), HasSubstr("a power of two"));
  EXPECT_THAT(refused(".const .b8 a[2] = {1,2,3};"), HasSubstr("too many initial values for 'a'"));
  EXPECT_THAT(refused(".const .u32 a = b;"), HasSubstr("64-bit elements"));
  EXPECT_THAT(refused(".global .b8 a[99999999999];"), HasSubstr("at most"));
  EXPECT_THAT(refused(".banana a, b;"), HasSubstr("directive '.banana'"));
  EXPECT_THAT(refused(".entry k() { add.u32 %r1,; }"), HasSubstr("';'; expected an operand"));
  EXPECT_EQ(refusal([] { parse(".version 7.5 .address_size 32", "m.ptx"); }),
            "m.ptx, PTX line 1: an address size other than 64; expected 64-bit PTX");
}

TEST(Parser, IgnoresTheNulBytesBehindNvidiasText) {
  std::string text = ptx_module(".entry k() { ret; }");
  text.append(3, '\0');
  EXPECT_EQ(parse(text, "m.ptx").functions.size(), 1u);
}

}  // namespace
}  // namespace warpgrain::profiler::ptx
