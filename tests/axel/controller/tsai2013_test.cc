// The plans of the published controller.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/axel.h"
#include "controller/axel/tsai2013_plan.h"
#include "sim/base/random.h"

namespace dockyard::axel {
namespace {

const Tsai2013Options kOptions;

Tsai2013Plan PlanFrom(const DockingCoords& at) {
  return PlanTsai2013(PlanGeometryOf(TestNominal()), kOptions, FromDockingCoords(at));
}

TEST(Tsai2013Plan, ApproachesByAForwardSToTheBorderOfTheAlignment) {
  RandomStream random(StreamKey(1, "approach"));
  int planned = 0;
  for (int i = 0; i < 200; ++i) {
    const DockingCoords at{random.Uniform(3.5, 6.0), Radians(random.Uniform(-20, 20)),
                           Radians(random.Uniform(-15, 15))};
    const Tsai2013Plan plan = PlanFrom(at);
    if (plan.step != Tsai2013Step::kApproach) continue;
    ++planned;
    const Pose2 end = Advance(FromDockingCoords(at), plan.arcs);
    EXPECT_NEAR(end.x, kOptions.align_r_m, 1e-9);
    EXPECT_NEAR(end.y, 0.0, 1e-9);
    EXPECT_NEAR(std::abs(end.heading), kPi, 1e-9);
    for (const Arc& arc : plan.arcs) EXPECT_GE(arc.length_m, -1e-9);
  }
  EXPECT_GT(planned, 150);
}

TEST(Tsai2013Plan, MatesWithinFiveDegreesAndRecoversBeyond) {
  EXPECT_EQ(PlanFrom({1.3, 0.0, Radians(4.9)}).step,
            Tsai2013Step::kRecover);  // tip beside the mouth
  EXPECT_EQ(PlanFrom({1.3, 0.0, Radians(1.0)}).step, Tsai2013Step::kMate);
  EXPECT_EQ(PlanFrom({1.3, Radians(5.1), Radians(5.1)}).step, Tsai2013Step::kRecover);
}

TEST(Tsai2013Plan, MatesUntilTheTipIsAtTheContact) {
  const Tsai2013Plan plan = PlanFrom({1.3, 0.0, 0.0});
  ASSERT_EQ(plan.step, Tsai2013Step::kMate);
  EXPECT_NEAR(plan.arcs[0].length_m, 0.3 + kOptions.contact_depth_m, 1e-9);
}

TEST(Tsai2013Plan, RecoversBackwardsOntoTheAxis) {
  const DockingCoords at{1.3, Radians(4.0), Radians(-7.0)};
  const Tsai2013Plan plan = PlanFrom(at);
  ASSERT_EQ(plan.step, Tsai2013Step::kRecover);
  const Pose2 end = Advance(FromDockingCoords(at), plan.arcs);
  EXPECT_NEAR(end.x, kOptions.recover_r_m, 1e-9);
  EXPECT_NEAR(end.y, 0.0, 1e-9);
  for (const Arc& arc : plan.arcs) EXPECT_LE(arc.length_m, 1e-9);
}

}  // namespace
}  // namespace dockyard::axel
