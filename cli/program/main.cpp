#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "cli/app.hpp"

// Ends without taking libraries down: PoCL's threads may still be at work on a program that was given up, as
// for a kernel that is not there, and crash then.
int main(int argc, char** argv) {
  const int status = warpgrain::cli::run_app(argc, argv);
  std::cout.flush();
  std::fflush(nullptr);
  std::_Exit(status);
}
