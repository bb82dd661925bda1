// Shards joined, and a sweep's table as CSV and Markdown.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/document_format.hpp"
#include "reports/merged_sweeps.hpp"
#include "reports/sweep_columns.hpp"
#include "reports/table_files.hpp"
#include "sample.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::HasSubstr;

std::string refusal(const std::vector<SweepShard>& shards) {
  try {
    merged(shards);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(MergedSweeps, TakeEveryCaseOnceAndPreferThoseThatAreDone) {
  SweepIndex first = sample::sweep(), second = sample::sweep();
  ASSERT_EQ(first.cases.size(), 2U);  // done, failed
  std::swap(second.cases[0].variant, second.cases[1].variant);
  second.cases[0].headline->warp_instructions += 7;  // of the case that failed in the first
  second.cases.push_back(second.cases[0]);
  second.cases.back().variant = "a/third/one";
  const SweepIndex all = merged(std::vector<SweepShard>{{"a", first}, {"b", second}});
  ASSERT_EQ(all.cases.size(), 3U);
  EXPECT_EQ(all.cases[0].variant, first.cases[0].variant);
  EXPECT_EQ(all.cases[0].status, CaseStatus::done);
  EXPECT_EQ(all.cases[1].status, CaseStatus::done);
  EXPECT_EQ(all.cases[1].headline->warp_instructions, first.cases[0].headline->warp_instructions + 7);
  EXPECT_EQ(all.cases[2].variant, "a/third/one");
}

TEST(MergedSweeps, RefuseOthersScenesAndOtherCounts) {
  SweepIndex other = sample::sweep();
  other.particles += 1;
  EXPECT_THAT(refusal({{"a", sample::sweep()}, {"b", other}}), HasSubstr("b: a sweep of "));
  other = sample::sweep();
  other.seed = 8;
  EXPECT_THAT(refusal({{"a", sample::sweep()}, {"b", other}}),
              HasSubstr("of seed 8; expected one of seed 7"));
  other.seed.reset();  // older than the key
  EXPECT_EQ(refusal({{"a", sample::sweep()}, {"b", other}}), "");
  other = sample::sweep();
  other.cases[0].headline->warp_instructions += 1;
  EXPECT_THAT(refusal({{"a", sample::sweep()}, {"b", other}}), HasSubstr("with other counts"));
  EXPECT_EQ(refusal({{"a", sample::sweep()}, {"b", sample::sweep()}}), "");
}

TEST(MergedSweeps, ReadTheirFolders) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "index.json", sweep_json(sample::sweep()));
  EXPECT_EQ(format_of(folder / "index.json"), sweep_format);
  const std::vector<std::string> folders{(folder / "").string()};
  EXPECT_EQ(read_shards(folders)[0].index.cases.size(), 2U);
  const std::vector<std::string> none{(folder / "none").string()};
  EXPECT_THROW(read_shards(none), InputError);
}

TEST(TableFiles, CsvHasARowACaseAndFullNumbers) {
  SweepIndex index = sample::sweep();
  index.cases[1].variant = "with, comma and \"quotes\"";
  const std::string text = csv_sweep(index);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_THAT(text, testing::StartsWith("variant,status,"));
  EXPECT_THAT(text, HasSubstr("\n\"with, comma and \"\"quotes\"\"\",failed,"));
  const std::string header = text.substr(0, text.find('\n'));
  EXPECT_EQ(static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1,
            2 + index.cases[0].axes.size() + sweep_columns(index).size());
}

TEST(TableFiles, MarkdownHasTheTerminalsColumns) {
  const std::string text = markdown_sweep(sample::sweep());
  for (const SweepColumn& column : sweep_columns(sample::sweep()))
    EXPECT_THAT(text, HasSubstr(std::string(column.heading)));
  EXPECT_THAT(text, HasSubstr("| `" + sample::sweep().cases[0].variant + "` |"));
}

}  // namespace
}  // namespace warpgrain::reports
