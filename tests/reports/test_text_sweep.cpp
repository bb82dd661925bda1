#include <gtest/gtest.h>

#include "reports/text_sweep.hpp"
#include "sample.hpp"

namespace warpgrain::reports {
namespace {

TEST(TextSweep, ARowACaseThenWhatRanWhereAndWhatDidNot) {
  EXPECT_EQ(text_sweep(sample::sweep()),
            R"(slit, 16,384 particles, step 4,000: 2 variants

                                                       of                                                       bytes
                                           SIMT  heaviest  active          warp           SFU                       a                 max      rms
variant                              efficiency    kernel   lanes  instructions  instructions  sectors/load  particle  time/step    error    error
-----------------------------------  ----------  --------  ------  ------------  ------------  ------------  --------  ---------  -------  -------
branchy/cells/cell/fp32/default           0.812     0.812     3.2            48            18          3.00        97    12.3 ms  1.5e-06  2.5e-08
branchy/cells/unsorted/fp32/default           -         -       -             -             -             -         -          -        -        -

heaviest kernel: force
opencl: pthread-device
simt: simulator
branchy/cells/unsorted/fp32/default: failed: step 12: particle 7 left the domain
)");
}

}  // namespace
}  // namespace warpgrain::reports
