// What watches every run fires on every back end (the test driver's CUDA device: tests/cuda).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command_fixture.hpp"
#include "core/error.hpp"
#include "detector_calls.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {
namespace {

using testing::HasSubstr;

using Detectors = CommandTest;

TEST_F(Detectors, FireOnEveryBackEnd) {
  for (const Backend& where : backends()) {
    if (!where.lacks().empty()) continue;
    for (const DetectorCall& bad : detector_calls()) {
      const std::string scene = write("scene.json", bad.scene.text());
      EXPECT_EQ(call({"run", "--scene", scene, "--backend", std::string(where.name), "--steps",
                      std::to_string(bad.steps), "--sample-every", "1", "--quiet"}),
                bad.status)
          << where.name << ": " << bad.what;
      for (const std::string& words : bad.says)
        EXPECT_THAT(err_, HasSubstr(words)) << where.name << ": " << bad.what;
    }
  }
}

// What the monitor would refuse first: the kernels themselves.
TEST(DetectorsOfKernels, NoForceOfCoincidentCentresIsSilent) {
  ExampleScene example;
  example.particles = two_spheres(0.005, 0.009, 0);
  Scene scene = example.scene();
  scene.particles.position[1] = scene.particles.position[0];
  for (const Backend& where : backends()) {
    if (!where.lacks().empty()) continue;
    EXPECT_THROW(where.create(scene, Variant(), {})->step(1), SimulationError) << where.name;
  }
}

}  // namespace
}  // namespace warpgrain::cli
