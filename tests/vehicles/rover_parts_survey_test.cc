// Two hundred scenes of a rover's parts, a rock and each other. A minute and a half.
#include <gtest/gtest.h>

#include <cstdio>

#include "vehicles/parts_scene.h"

namespace dockyard {
namespace {

TEST(RoverPartsSurvey, GoThroughNothingInTwoHundredScenes) {
  int overlaps = 0;
  double deepest_m = 0.0;
  for (std::uint64_t scene = 1; scene <= 200; ++scene) {
    const double depth_m = OverlapOfScene(scene);
    deepest_m = std::max(deepest_m, depth_m);
    if (depth_m < kMostOverlap_m) continue;
    ++overlaps;
    std::printf("scene %d: %.1f mm\n", static_cast<int>(scene), 1e3 * depth_m);
    std::fflush(stdout);
  }
  std::printf("%d of 200 overlap, the deepest by %.1f mm\n", overlaps, 1e3 * deepest_m);
  EXPECT_EQ(overlaps, 0);
}

}  // namespace
}  // namespace dockyard
