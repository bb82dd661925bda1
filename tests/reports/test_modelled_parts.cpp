// What documents say of the model that their kernels compute, and how those are read that say nothing.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file_io.hpp"
#include "reports/modelled_parts.hpp"
#include "reports/report_json.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ModelledParts, AreWrittenForPeople) {
  const std::string text = text_modelled_parts(sample::modelled());
  EXPECT_THAT(text, HasSubstr("left out of the model: gravity (zero)\n"));
  EXPECT_THAT(text, HasSubstr("device memory: 96 bytes a particle"));
  EXPECT_THAT(text, HasSubstr("25.0 %"));
  ModelledParts full = sample::modelled();
  for (FeatureRow& row : full.features) row.modelled = true;
  EXPECT_THAT(text_modelled_parts(full), HasSubstr("left out of the model: nothing"));
  EXPECT_EQ(text_modelled_parts({}), "");
}

TEST(ModelledParts, ComeBackFromADocument) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "run.json", run_json(sample::run()));
  const RunReport back = read_run(folder / "run.json");
  EXPECT_EQ(back.variant, sample::run().variant);
  EXPECT_EQ(run_json(back), run_json(sample::run()));
}

// Whatever is older than the axis ran the full model.
TEST(ModelledParts, AreAllOfThemInOlderDocuments) {
  const TemporaryFolder folder;
  RunReport run = sample::run();
  run.model = {};
  write_file_atomically(folder / "run.json", run_json(run));
  EXPECT_EQ(read_run(folder / "run.json").variant, run.variant + "/model=full");
  MeasuredReport measured = sample::measured();  // readings that are kept had names before they had features
  measured.model = {};
  write_file_atomically(folder / "measured.json", measured_json(measured));
  EXPECT_EQ(read_measured(folder / "measured.json").variant, *measured.variant);
  Report report = sample::report();
  report.model = {};
  write_file_atomically(folder / "report.json", report_json(report));
  EXPECT_EQ(read_report(folder / "report.json").variant, *report.variant + "/model=full");
  SweepIndex sweep = sample::sweep();
  for (SweepCase& row : sweep.cases) row.axes.erase("model");
  write_file_atomically(folder / "index.json", sweep_json(sweep));
  EXPECT_EQ(read_sweep(folder / "index.json").cases[0].variant, sweep.cases[0].variant + "/model=full");
}

}  // namespace
}  // namespace warpgrain::reports
