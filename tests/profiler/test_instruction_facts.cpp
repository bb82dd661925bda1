#include <gtest/gtest.h>
#include <string>

#include "profiler/ptx/instruction_facts.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using Class = InstructionClass;

// A statement from its opcode alone: "ld.global.v4.f32".
InstructionFacts facts_of(const std::string& opcode) {
  Statement statement;
  std::size_t begin = opcode.find('.');
  statement.opcode = opcode.substr(0, begin);
  while (begin != std::string::npos) {
    const std::size_t end = opcode.find('.', begin + 1);
    statement.modifiers.push_back(opcode.substr(begin + 1, end == std::string::npos ? end : end - begin - 1));
    begin = end;
  }
  return instruction_facts(statement);
}

TEST(InstructionFacts, Classes) {
  const std::pair<const char*, Class> cases[] = {{"add.rn.f32", Class::fp32},
                                                 {"fma.rn.f64", Class::fp64},
                                                 {"add.s32", Class::integer},
                                                 {"mad.wide.u32", Class::integer},
                                                 {"and.pred", Class::predicate},
                                                 {"setp.lt.f32", Class::predicate},
                                                 {"cvt.rn.f32.s32", Class::conversion},
                                                 {"mov.u32", Class::move},
                                                 {"selp.f32", Class::move},
                                                 {"sqrt.approx.f32", Class::special_function},
                                                 {"bra.uni", Class::branch},
                                                 {"ret", Class::exit},
                                                 {"bar.sync", Class::barrier},
                                                 {"membar.gl", Class::fence},
                                                 {"call.uni", Class::branch},
                                                 {"ld.param.u64", Class::parameter_load},
                                                 {"ld.const.f32", Class::constant_load},
                                                 {"ld.local.u32", Class::local_load},
                                                 {"st.local.u32", Class::local_store},
                                                 {"ld.f32", Class::generic_load},
                                                 {"st.v2.f32", Class::generic_store},
                                                 {"div.full.f32", Class::fp32},
                                                 {"red.global.add.u32", Class::atomic}};
  for (const auto& [opcode, expected] : cases)
    EXPECT_EQ(instruction_class_name(facts_of(opcode).instruction_class), instruction_class_name(expected))
        << opcode;
}

TEST(InstructionFacts, BytesOfTracedAccesses) {
  EXPECT_EQ(facts_of("ld.global.v4.f32").accessed_bytes, 16);
  EXPECT_EQ(facts_of("ld.global.nc.u8").accessed_bytes, 1);
  EXPECT_EQ(facts_of("st.shared.f64").accessed_bytes, 8);
  EXPECT_EQ(facts_of("st.v2.u32").accessed_bytes, 8);
  EXPECT_EQ(facts_of("atom.global.cas.b64").accessed_bytes, 8);
  for (const char* opcode :
       {"ld.param.f32", "ld.const.f32", "ld.local.f32", "st.local.f32", "st.param.f32", "add.f32"})
    EXPECT_EQ(facts_of(opcode).accessed_bytes, 0) << opcode;
}

TEST(InstructionFacts, UsesOfTheSpecialFunctionUnit) {
  const std::pair<const char*, int> cases[] = {
      {"sqrt.approx.f32", 1}, {"rsqrt.approx.f32", 1}, {"rcp.rn.f32", 1},  {"sin.approx.f32", 1},
      {"div.full.f32", 1},    {"div.rn.f64", 1},       {"div.u32", 3},     {"rem.s32", 3},
      {"cvt.rn.f32.s32", 1},  {"cvt.rzi.s32.f32", 1},  {"cvt.f64.f32", 1}, {"cvt.rmi.f32.f32", 1},
      {"cvt.u64.u32", 0},     {"cvt.sat.f32.f32", 0},  {"fma.rn.f32", 0},  {"mul.hi.u32", 0}};
  for (const auto& [opcode, expected] : cases) EXPECT_EQ(facts_of(opcode).sfu_operations, expected) << opcode;
}

}  // namespace
}  // namespace warpgrain::profiler::ptx
