// A rover's parts against rocks and against each other: none goes through another.
#include <gtest/gtest.h>

#include "vehicles/parts_scene.h"

namespace dockyard {
namespace {

TEST(RoverParts, AreClearOfEachOtherAsStowedAndAsOnWatch) {
  ArmRig rig(Rocky7(), "compact_gravel");
  const auto points_L = PointsOf(rig.parts);
  rig.Run(0.1);
  EXPECT_TRUE(rig.parts.met().empty());
  EXPECT_EQ(DeepestOverlap(rig.parts, rig.world, points_L), 0.0);
  rig.body.PutMast(rig.model.mast->watch_rad);
  rig.Run(0.1);
  EXPECT_TRUE(rig.parts.met().empty());
  EXPECT_EQ(DeepestOverlap(rig.parts, rig.world, points_L), 0.0);
}

TEST(RoverParts, GoThroughNoRockAndNotThroughEachOther) {
  for (std::uint64_t scene = 1; scene <= 6; ++scene) {
    EXPECT_LT(OverlapOfScene(scene), kMostOverlap_m) << scene;
  }
}

}  // namespace
}  // namespace dockyard
