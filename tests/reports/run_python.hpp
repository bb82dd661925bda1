#pragma once
// Debian's Python for what it checks better than C++ would: JSON Schemas and XML.

#include <filesystem>
#include <string>
#include <vector>

namespace warpgrain::reports {

// Runs tests/reports/SCRIPT with the files as arguments and returns the lines that it prints. Fails the test
// when the script does. Debian's interpreter is called by its path because `python3` may be another one
// without its modules.
std::vector<std::string> run_python(const std::string& script,
                                    const std::vector<std::filesystem::path>& files);

}  // namespace warpgrain::reports
