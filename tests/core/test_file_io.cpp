#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class FileIo : public testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(FileIo, ReadsWhatItWrote) {
  const std::string text("a\0b\r\nc", 6);
  write_file_atomically(folder_ / "file", text);
  EXPECT_EQ(read_text_file(folder_ / "file", 6), text);
  write_file_atomically(folder_ / "file", "");
  EXPECT_EQ(read_text_file(folder_ / "file", 6), "");
}

TEST_F(FileIo, RefusesLargeMissingAndOddFiles) {
  write_file_atomically(folder_ / "file", "1234567");
  EXPECT_THAT([&] { read_text_file(folder_ / "file", 6); },
              ThrowsMessage<InputError>(HasSubstr("7 bytes; expected at most 6 bytes")));
  EXPECT_THAT([&] { read_text_file(folder_ / "none", 6); },
              ThrowsMessage<InputError>(HasSubstr("none: no such file")));
  EXPECT_THROW(read_text_file(folder_.path(), 6), InputError);
}

TEST_F(FileIo, SaysWhyAFileCannotBeWritten) {
  EXPECT_THAT([&] { write_file_atomically(folder_ / "no" / "file", "x"); },
              ThrowsMessage<InputError>(HasSubstr("cannot be written: No such file or directory")));
}

}  // namespace
}  // namespace warpgrain
