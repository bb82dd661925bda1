#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

#include "core/error.hpp"
#include "reports/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t entries_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(AtomicFile, WritesAndReplacesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const fs::path file = folder / "deep" / "report.json";
  write_file_atomically(file, "one");
  EXPECT_EQ(content_of(file), "one");
  write_file_atomically(file, "two");
  EXPECT_EQ(content_of(file), "two");
  EXPECT_EQ(entries_in(folder / "deep"), 1u);
}

TEST(AtomicFile, AFailureLeavesNoTemporaryAndNamesTheFile) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "taken" / "inside");  // a folder that is not empty: rename over it fails
  try {
    write_file_atomically(folder / "taken", "text");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr((folder / "taken").string() + ": cannot be written: "));
  }
  EXPECT_EQ(entries_in(folder.path()), 1u);
}

TEST(AtomicFile, AFileWhereAFolderShouldBe) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "plain", "text");
  EXPECT_THROW(write_file_atomically(folder / "plain" / "report.json", "text"), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
