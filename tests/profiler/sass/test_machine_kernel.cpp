// That lines leave the machine code as it is, for PTX of clang's and nvcc's making, and what happens where
// not.

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "profiler/sass/line_directives.hpp"
#include "profiler/sass/machine_kernel.hpp"
#include "profiler/subprocess.hpp"
#include "tests/paths.hpp"

namespace warpgrain::profiler::sass {
namespace {

KernelCode a_row_of_code() {
  KernelCode code;
  code.text = std::string(32, 'x');
  code.lines = {{0, 7}};
  return code;
}

TEST(MachineKernel, LinesMayNotChangeTheCode) {
  const KernelCode code = a_row_of_code();
  EXPECT_NO_THROW(require_same_code(code, code, "k"));
  KernelCode other = code;
  other.text[17] = 'y';
  try {
    require_same_code(other, code, "k");
    FAIL() << "a byte differs";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("other machine code with lines"), std::string::npos);
  }
  other = code;
  other.lines.clear();
  EXPECT_THROW(require_same_code(other, code, "k"), InputError);
}

TEST(MachineKernel, CodeIsTheSameWithAndWithoutLines) {
  const std::optional<Ptxas> ptxas = find_ptxas();
  if (!ptxas) GTEST_SKIP() << "ptxas is not installed";
  const std::filesystem::path kernels = source_path("tests/exactness/kernels");
  for (const std::string name : {"shuffles", "jump_table"}) {  // of nvcc; by hand
    SCOPED_TRACE(name);
    const AssemblerText text = assembler_text(read_text(kernels / (name + ".ptx")));
    for (const char* arch : {"sm_80", "sm_90"}) {
      const KernelCode plain = read_kernel_code(assemble(*ptxas, text.plain, arch, LineTable::without), name);
      const KernelCode lines =
          read_kernel_code(assemble(*ptxas, text.with_lines, arch, LineTable::with), name);
      EXPECT_FALSE(plain.text.empty());
      EXPECT_NO_THROW(require_same_code(lines, plain, name));
    }
  }
}

}  // namespace
}  // namespace warpgrain::profiler::sass
