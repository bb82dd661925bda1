#include "reports/generator.hpp"

namespace warpgrain::reports {

Generator this_generator() { return {WARPGRAIN_VERSION, WARPGRAIN_GIT_REVISION}; }

}  // namespace warpgrain::reports
