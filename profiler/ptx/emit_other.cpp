// Instructions that ask about addresses, wait, or advise; and those that are refused, by what they are about.

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

// isspacep.space p, a: of a generic address.
void emit_isspacep(Emitter& e) {
  const auto space = e.modifiers().take_space();
  if (!space) e.refuse(".global, .shared, .const, .local or .param");
  e.write(e.lies_in(*space, e.read(1, bits_type(64))), predicate_type);
}

// Time does not pass.
void emit_nanosleep(Emitter& e) {
  e.take_type(Emitter::Types::integer);
  e.read(0, bits_type(32));
}

// Events of a profiler's counters, and advice to caches, leave every value as it is.
void emit_advice(Emitter& e) {
  for (std::size_t i = 0; i < e.operand_count(); ++i) e.operand(i);
  e.modifiers().take("mask");
  e.modifiers().take_space();
  e.modifiers().drop_prefixed("L2");
}

}  // namespace

const InstructionTable& other_instructions() {
  static const InstructionTable table{
      {"isspacep", emit_isspacep}, {"nanosleep", emit_nanosleep},  {"pmevent", emit_advice},
      {"discard", emit_advice},    {"applypriority", emit_advice},
  };
  return table;
}

std::string_view what_is_expected_instead(std::string_view opcode) {
  static constexpr std::string_view textures = "a kernel without textures";
  static constexpr std::string_view surfaces = "a kernel without surfaces";
  static constexpr std::string_view matrices = "a kernel without matrix instructions";
  static constexpr std::string_view video = "a kernel without video instructions";
  static constexpr std::string_view copies = "a kernel without asynchronous copies";
  static constexpr std::string_view clusters = "a kernel without thread-block clusters";
  static constexpr std::string_view stack = "a kernel whose local memory has a fixed size";
  static const std::unordered_map<std::string_view, std::string_view> families{
      {"tex", textures},
      {"tld4", textures},
      {"txq", textures},
      {"istypep", textures},
      {"suld", surfaces},
      {"sust", surfaces},
      {"sured", surfaces},
      {"suq", surfaces},
      {"mma", matrices},
      {"wmma", matrices},
      {"wgmma", matrices},
      {"tcgen05", matrices},
      {"ldmatrix", matrices},
      {"stmatrix", matrices},
      {"movmatrix", matrices},
      {"vadd", video},
      {"vsub", video},
      {"vabsdiff", video},
      {"vmin", video},
      {"vmax", video},
      {"vshl", video},
      {"vshr", video},
      {"vmad", video},
      {"vset", video},
      {"vadd2", video},
      {"vsub2", video},
      {"vavrg2", video},
      {"vabsdiff2", video},
      {"vmin2", video},
      {"vmax2", video},
      {"vset2", video},
      {"vadd4", video},
      {"vsub4", video},
      {"vavrg4", video},
      {"vabsdiff4", video},
      {"vmin4", video},
      {"vmax4", video},
      {"vset4", video},
      {"cp", copies},
      {"createpolicy", copies},
      {"mbarrier", "a kernel without mbarrier objects"},
      {"mapa", clusters},
      {"getctarank", clusters},
      {"clusterlaunchcontrol", clusters},
      {"multimem", "a kernel for one device"},
      {"griddepcontrol", "a kernel that waits for no other"},
      {"setmaxnreg", "a kernel with a fixed number of registers"},
      {"tensormap", copies},
      {"alloca", stack},
      {"stacksave", stack},
      {"stackrestore", stack},
  };
  const auto found = families.find(opcode);
  return found == families.end() ? std::string_view() : found->second;
}

}  // namespace warpgrain::profiler::ptx
