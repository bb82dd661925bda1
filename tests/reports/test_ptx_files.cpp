#include <gtest/gtest.h>

#include "core/file_io.hpp"
#include "reports/ptx_files.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

TEST(PtxFiles, EachModuleIsKeptOnceBesideTheReport) {
  const std::vector launches{sample::launch("sort"), sample::launch("force"), sample::launch("force")};
  Report report = make_report(launches, "");
  EXPECT_EQ(report.launches[0].ptx.hash, text_hash("// sort"));
  EXPECT_EQ(report.launches[0].ptx.file, "");
  const TemporaryFolder folder;
  keep_ptx(report, launches, folder / "slit.report.json");
  EXPECT_EQ(report.launches[0].ptx.file, "slit.report.ptx");
  EXPECT_EQ(report.launches[1].ptx.file, "slit.report-2.ptx");
  EXPECT_EQ(report.launches[2].ptx.file, "slit.report-2.ptx");
  EXPECT_EQ(read_text_file(folder / "slit.report.ptx", 100), "// sort");
  EXPECT_EQ(read_text_file(folder / "slit.report-2.ptx", 100), "// force");
}

}  // namespace
}  // namespace warpgrain::reports
