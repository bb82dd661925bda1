#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/temporary_folder.hpp"
#include "variants/kernel_sources.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;
using testing::Not;

class KernelFolder : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  static std::string message_of(auto&& call) {
    try {
      call();
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  }

  TemporaryFolder folder_;
};

TEST_F(KernelFolder, BundlesTheEmbeddedFilesWithTrueLines) {
  const std::vector<std::string> files{"integrate.cl"};
  const std::string text = KernelSources().bundle(files);
  EXPECT_THAT(text, HasSubstr("#line 1 \"kernels/integrate.cl\"\n"));
  EXPECT_THAT(text, HasSubstr("#line 1 \"kernels/layout.h\"\n"));
  EXPECT_THAT(text, HasSubstr("KERNEL void integrate("));
  EXPECT_THAT(text, Not(HasSubstr("#include \"")));
}

TEST_F(KernelFolder, ShadowsTheEmbeddedFilesAndIncludesEachOnce) {
  write("integrate.cl", "first\n#include \"a.h\"\n  #  include \"a.h\"\nlast");
  write("a.h", "inside\n");
  const std::vector<std::string> files{"integrate.cl"};
  EXPECT_EQ(KernelSources(folder_.path()).bundle(files),
            "#line 1 \"" + path("integrate.cl") + "\"\nfirst\n#line 1 \"" + path("a.h") +
                "\"\ninside\n#line 3 \"" + path("integrate.cl") + "\"\n#line 4 \"" + path("integrate.cl") +
                "\"\nlast\n");
}

// What is left out takes the #line behind an #include with it.
TEST_F(KernelFolder, LinesAreTrueBehindAnIncludeThatIsLeftOut) {
  write("integrate.cl", "#ifdef NEVER\n#include \"a.h\"\n#else\nfourth\n#endif\nsixth");
  write("a.h", "one\ntwo\n");
  const std::vector<std::string> files{"integrate.cl"};
  const std::string text = KernelSources(folder_.path()).bundle(files);
  EXPECT_THAT(text, HasSubstr("#else\n#line 4 \"" + path("integrate.cl") + "\"\nfourth\n"));
  EXPECT_THAT(text, HasSubstr("#endif\n#line 6 \"" + path("integrate.cl") + "\"\nsixth\n"));
}

TEST_F(KernelFolder, NamesTheLineThatIncludesAMissingFile) {
  write("integrate.cl", "first\n#include \"gone.h\"\n");
  const std::vector<std::string> files{"integrate.cl"};
  EXPECT_EQ(message_of([&] { KernelSources(folder_.path()).bundle(files); }),
            path("integrate.cl") + ":2: no kernel file 'gone.h'");
}

TEST_F(KernelFolder, RefusesAFolderThatIsNotThereOrHoldsNoKernel) {
  EXPECT_THAT(message_of([&] { KernelSources(folder_ / "none"); }), HasSubstr("none: not a folder"));
  EXPECT_THAT(message_of([&] { KernelSources sources(folder_.path()); }), HasSubstr("no kernel file there"));
}

}  // namespace
}  // namespace warpgrain
