// The main function of test programs that use an OpenCL device. PoCL's threads may still be at work on a
// program that was given up (a kernel that is not there) when the process takes its libraries down, and crash
// then: the process ends without that.

#include <cstdio>
#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  const int status = RUN_ALL_TESTS();
  std::fflush(nullptr);
  std::_Exit(status);
}
