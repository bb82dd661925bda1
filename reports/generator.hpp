#pragma once
// What wrote a document: part of the provenance of every format.

#include <string>

namespace warpgrain::reports {

struct Generator {
  std::string version;       // "0.1.0"
  std::string git_revision;  // of the source tree at configuration, "-dirty" when it was changed; "unknown"
                             // without git
};

// This program.
Generator this_generator();

}  // namespace warpgrain::reports
