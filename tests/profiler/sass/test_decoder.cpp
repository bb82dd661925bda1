// The decoder against listings, instruction by instruction: those in data/, and whatever has been committed
// below reports/measured/.

#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <unistd.h>

#include "profiler/sass/decoder.hpp"
#include "tests/paths.hpp"
#include "tests/profiler/sass/listing.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::profiler::sass {
namespace {

std::vector<std::filesystem::path> listings() {
  std::vector<std::filesystem::path> found;
  for (const std::string& folder : {source_path("tests/profiler/sass/data"), source_path("reports/measured")})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".sass") found.push_back(entry.path());
  return found;
}

std::string guard_text(const Instruction& i) {
  if (i.guard == always && !i.guard_negated) return {};
  return fmt::format("@{}P{}", i.guard_negated ? "!" : "", i.guard == always ? "T" : std::to_string(i.guard));
}

// "IMAD.MOV.U32" is an IMAD to us, "IMAD.WIDE.U32" an IMAD.WIDE. On sm_90 RED is called REDG.
bool is_named(std::string_view listed, std::string_view ours) {
  if (ours == "RED" && listed.starts_with("REDG.")) return true;
  return listed == ours || (listed.starts_with(ours) && listed[ours.size()] == '.');
}

// Where the operands of a jump point: `(.L_x_3) or 0x1b0.
std::uint32_t listed_target(const ListedKernel& kernel, const std::string& operands) {
  static const std::regex to_label(R"(`\(([.$][A-Za-z0-9_.$]+)\))"), to_address("0x([0-9a-f]+)");
  std::smatch match;
  if (std::regex_search(operands, match, to_label)) {
    const auto found = kernel.labels.find(match[1]);
    return found == kernel.labels.end() ? no_target : found->second;
  }
  if (std::regex_search(operands, match, to_address))
    return static_cast<std::uint32_t>(std::stoul(match[1], nullptr, 16));
  return no_target;
}

// The predicates that an instruction writes stand before its operands, or behind its first register. VOTE's
// second one is what it asks for; R2P writes all.
unsigned listed_predicates(const ListedInstruction& listed) {
  static const std::regex predicate("P[0-6T]");
  if (listed.mnemonic == "R2P") return 0x7F;
  std::vector<std::string> operands;
  std::istringstream text(listed.operands);
  for (std::string operand; std::getline(text, operand, ',');) {
    const std::size_t first = operand.find_first_not_of(' ');
    operands.push_back(
        first == std::string::npos ? "" : operand.substr(first, operand.find_last_not_of(' ') + 1 - first));
  }
  const bool is_vote = listed.mnemonic.starts_with("VOTE");
  unsigned written = 0, predicates = 0, registers = 0;
  for (const std::string& operand : operands) {
    if (!std::regex_match(operand, predicate)) {
      if (predicates != 0 || ++registers > 1) break;
      continue;
    }
    if (is_vote && predicates == 1) break;
    if (++predicates > 2) break;
    if (operand != "PT") written |= 1U << static_cast<unsigned>(operand[1] - '0');
  }
  return written;
}

void compare(const ListedKernel& kernel, const ListedInstruction& listed, const Instruction& ours) {
  SCOPED_TRACE(fmt::format("{:04x} {} {}{}", listed.address, listed.guard, listed.mnemonic, listed.operands));
  std::string guard = listed.guard;
  if (guard.find("UP") != std::string::npos) guard.erase(guard.find('U'), 1);  // of the uniform datapath
  EXPECT_EQ(guard_text(ours), guard);
  EXPECT_TRUE(is_named(listed.mnemonic, mnemonic(ours))) << mnemonic(ours);
  if (ours.flow == Flow::none && listed.mnemonic[0] != 'U' && listed.mnemonic != "R2UR") {
    EXPECT_EQ(ours.predicates_written, listed_predicates(listed));
  }
  if (listed.mnemonic == "PLOP3.LUT") {
    const std::string operands = listed.operands.substr(0, listed.operands.find_last_not_of(' ') + 1);
    const bool constant =
        operands.ends_with(", PT, PT, PT, 0x80, 0x0") || operands.ends_with(", PT, PT, PT, 0x8, 0x0");
    EXPECT_EQ(ours.constant_predicate, !constant ? -1 : operands.ends_with("0x80, 0x0") ? 1 : 0);
  }
  if (ours.target != no_target) {
    EXPECT_EQ(ours.target, listed_target(kernel, listed.operands));
  }
  const bool divergent = listed.mnemonic.find(".DIV") != std::string::npos && ours.flow == Flow::branch;
  EXPECT_EQ(ours.if_divergent, divergent);
  std::smatch match;
  static const std::regex barrier(R"(\bB([0-9]+)\b)"), condition(R"(^\s*(!?)(U?)P([0-9]),)");
  if (ours.flow == Flow::open || ours.flow == Flow::meet || ours.flow == Flow::leave ||
      ours.flow == Flow::save || ours.flow == Flow::restore) {
    ASSERT_TRUE(std::regex_search(listed.operands, match, barrier));
    EXPECT_EQ(ours.barrier, std::stoul(match[1]));
  }
  if (ours.flow == Flow::branch && std::regex_search(listed.operands, match, condition)) {
    EXPECT_EQ(ours.condition, std::stoul(match[3]));
    EXPECT_EQ(ours.condition_negated, match[1].length() != 0);
    EXPECT_EQ(ours.uniform_condition, match[2].length() != 0);
  } else if (ours.flow == Flow::branch) {
    EXPECT_EQ(ours.condition, always);
  }
}

// How many instructions were compared: all but the padding behind the code.
std::size_t compare_listing(const std::filesystem::path& path) {
  SCOPED_TRACE(path.string());
  std::size_t compared = 0;
  const Listing listing = read_listing(path);
  for (const ListedKernel& kernel : listing.kernels) {
    SCOPED_TRACE(kernel.name);
    const std::vector<Instruction> ours = decode(kernel.code(), listing.sm);
    EXPECT_LE(ours.size(), kernel.instructions.size());
    for (std::size_t k = 0; k < kernel.instructions.size(); ++k) {
      if (k < ours.size())
        compare(kernel, kernel.instructions[k], ours[k]);
      else
        EXPECT_TRUE(kernel.instructions[k].mnemonic == "NOP" || kernel.instructions[k].mnemonic == "BRA");
    }
    compared += ours.size();
  }
  return compared;
}

TEST(Decoder, AgreesWithListings) {
  std::size_t compared = 0;
  for (const auto& path : listings()) compared += compare_listing(path);
  EXPECT_GE(compared, 200U);
}

struct Compared {
  std::size_t files = 0, instructions = 0;
};

// By architecture, "sm_75"; listings without one in their name are of sm_90.
std::map<std::string, Compared> compare_archive(const std::string& name, const std::string& inside) {
  const std::filesystem::path archive =
      std::filesystem::path(source_path("reports/measured/exactness")) / name;
  const TemporaryFolder folder;
  const std::string command =
      fmt::format("tar -xJf '{}' -C '{}' {} 2>&1", archive.string(), folder.path().string(), inside);
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::map<std::string, Compared> compared;
  for (const auto& entry : std::filesystem::directory_iterator(folder / inside)) {
    if (entry.path().extension() != ".sass") continue;
    const std::string arch = entry.path().stem().extension().string();
    Compared& sum = compared[arch.empty() ? "sm_90" : arch.substr(1)];
    const std::size_t of_file = compare_listing(entry.path());
    EXPECT_GT(of_file, 0U) << entry.path();
    ++sum.files;
    sum.instructions += of_file;
  }
  return compared;
}

bool can_unpack() { return std::system("xz --version > /dev/null 2>&1") == 0; }

// Of every launch of which the machine code was kept.
TEST(Decoder, AgreesWithTheListingsOfTheReadings) {
  if (!can_unpack()) GTEST_SKIP() << "xz, which unpacks the readings, is missing";
  const auto compared = compare_archive("h100.tar.xz", "code");
  EXPECT_GE(compared.at("sm_90").files, 62U);
  EXPECT_GE(compared.at("sm_90").instructions, 5000U);
}

TEST(Decoder, AgreesWithListingsOfEveryOtherArchitecture) {
  if (!can_unpack()) GTEST_SKIP() << "xz, which unpacks the listings, is missing";
  const auto compared = compare_archive("listings.tar.xz", "listings");
  for (const char* arch : {"sm_75", "sm_80", "sm_86", "sm_87", "sm_89"}) {
    SCOPED_TRACE(arch);
    ASSERT_TRUE(compared.contains(arch));
    EXPECT_GE(compared.at(arch).files, 15U);
    EXPECT_GE(compared.at(arch).instructions, 1000U);
  }
}

TEST(Decoder, DropsThePaddingBehindTheCode) {
  // EXIT; BRA to itself; NOP, of sm_90.
  ListedKernel kernel;
  kernel.instructions = {{0x00, "", "EXIT", "", 0x000000000000794d, 0x000fea0003800000},
                         {0x10, "", "BRA", " 0x10", 0xfffffffc00fc7947, 0x000fc0000383ffff},
                         {0x20, "", "NOP", "", 0x0000000000007918, 0x000fc00000000000}};
  const std::vector<Instruction> ours = decode(kernel.code(), 90);
  ASSERT_EQ(ours.size(), 1U);
  EXPECT_EQ(ours[0].flow, Flow::exit);
  EXPECT_FALSE(ours[0].is_conditional());
}

}  // namespace
}  // namespace warpgrain::profiler::sass
