// Shell completion, asked of bash itself, and the manual page, asked of groff where there is one.

#include <array>
#include <cstdio>
#include <gmock/gmock.h>
#include <memory>

#include "tests/cli/command_fixture.hpp"

namespace warpgrain::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> piece;
  while (const std::size_t n = fread(piece.data(), 1, piece.size(), pipe.get())) text.append(piece.data(), n);
  return text;
}

class Completion : public CommandTest {
 protected:
  // What bash offers behind these words, of which the last is being typed.
  std::string offered(const std::string& words) {
    EXPECT_EQ(call({"completion", "bash"}), 0);
    const std::string script = write("completion.bash", out_);
    return output_of(
        "bash -c 'source " + script + "; COMP_WORDS=(" + words +
        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _warpgrain; echo \" ${COMPREPLY[*]} \"' 2>&1");
  }
};

TEST_F(Completion, OffersCommandsOptionsAndValues) {
  EXPECT_EQ(offered("warpgrain swe"), " sweep \n");
  EXPECT_THAT(offered("warpgrain \"\""), HasSubstr(" profile "));
  EXPECT_EQ(offered("warpgrain run --until"), " --until-rest \n");
  EXPECT_THAT(offered("warpgrain run --contact \"\""), HasSubstr(" branchless "));
  EXPECT_EQ(offered("warpgrain profile --machine hop"), " hopper_h100 \n");
  EXPECT_THAT(offered("warpgrain run --scene \"\""), HasSubstr(" slit "));
  EXPECT_EQ(offered("warpgrain run some_file"), "  \n") << "files are the shell's own matter";
}

TEST_F(Completion, OtherShellsAndUnknownOnes) {
  EXPECT_EQ(call({"completion", "fish"}), 0);
  EXPECT_THAT(out_, HasSubstr("__fish_seen_subcommand_from run' -l contact"));
  EXPECT_EQ(call({"completion", "zsh"}), 0);
  EXPECT_THAT(out_, HasSubstr("bashcompinit"));
  EXPECT_EQ(call({"completion", "tcsh"}), 2);
  EXPECT_EQ(err_, "warpgrain completion: unknown shell 'tcsh'; valid: bash, fish, zsh\n");
}

TEST_F(Completion, ManualPageHasEveryCommand) {
  EXPECT_EQ(call({"man"}), 0);
  for (const char* command : {"list", "run", "profile", "sweep", "man"})
    EXPECT_THAT(out_, HasSubstr(std::string(".SH COMMAND ") + command + "\n"));
  EXPECT_THAT(out_, HasSubstr("\\-\\-until\\-rest"));
  if (output_of("command -v groff").empty()) return;
  const std::string page = write("warpgrain.1", out_);
  EXPECT_EQ(output_of("groff -man -Tascii -ww " + page + " 2>&1 >/dev/null"), "") << "warnings of groff";
}

}  // namespace
}  // namespace warpgrain::cli
