#include <gtest/gtest.h>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/axel.h"

namespace dockyard::axel {
namespace {

struct Outcome {
  Verdict verdict = Verdict::kUnderWay;
  double depth_m = 0.0;
  int sightings = 0;
};

Outcome Reel(const DockingCoords& start) {
  const Nominal nominal = TestNominal();
  KinematicWorld world;
  world.jam_depth_m = 0.27;  // the socket's end
  KinematicRover rover(nominal, world, FromDockingCoords(start));
  const auto controller = MakeReelOnlyController(nominal);
  Outcome outcome;
  for (int i = 0; i < 15'000 && outcome.verdict == Verdict::kUnderWay; ++i) {
    const Commands commands = controller->Step(rover.Sense());
    if (!commands.take_images.empty()) ++outcome.sightings;
    rover.Step(commands);
    outcome.verdict = commands.verdict;
  }
  outcome.depth_m = rover.depth_m();
  return outcome;
}

TEST(ReelOnly, DocksStraightAhead) {
  const Outcome outcome = Reel({3.0, 0.0, 0.0});
  EXPECT_EQ(outcome.verdict, Verdict::kDone);
  EXPECT_GT(outcome.depth_m, 0.20);
}

TEST(ReelOnly, SwingsAroundFromALargeHeading) {
  EXPECT_GT(Reel({3.0, 0.0, Radians(60.0)}).depth_m, 0.20);
}

TEST(ReelOnly, TakesNoImages) { EXPECT_EQ(Reel({2.0, 0.0, 0.0}).sightings, 0); }

}  // namespace
}  // namespace dockyard::axel
