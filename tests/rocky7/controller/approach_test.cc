#include "controller/rocky7/approach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "controller/motion/clearance.h"
#include "controller/rocky7/dockyard.h"
#include "controller/rocky7/paths_to_point.h"
#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

using testing::HasSubstr;

TEST(ArcsToPoint, EndOnThePointWithinTheSteeringsLimits) {
  const Nominal nominal = NominalRover();
  const ArcLimits limits = GentleLimits(nominal.plan);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> ahead(-0.5, 2.5), aside(-1.0, 1.0);
  int pairs = 0;
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector2d goal(ahead(random), aside(random));
    const std::vector<Arc> path = ArcsToPoint(goal, nominal.plan.p_RP, limits);
    ASSERT_FALSE(path.empty()) << goal.transpose();
    for (const Arc& arc : path) EXPECT_TRUE(Keeps(arc, limits));
    EXPECT_LT((Advance({}, path) * nominal.plan.p_RP - goal).norm(), 1e-9);
    pairs += path.size() == 2;
  }
  EXPECT_GT(pairs, 500);
}

// One arc to a point 2 cm aside turns about a centre 1 cm away, which no wheel steers.
TEST(ArcsToPoint, BackUpForAPointAside) {
  const Nominal nominal = NominalRover();
  const ArcLimits limits = GentleLimits(nominal.plan);
  const Eigen::Vector2d goal = nominal.plan.p_RP + Eigen::Vector2d(0.0, 0.02);
  ASSERT_FALSE(Keeps(*OneArcTo(goal, nominal.plan.p_RP), limits));
  const std::vector<Arc> path = ArcsToPoint(goal, nominal.plan.p_RP, limits);
  ASSERT_EQ(path.size(), 2u);
  EXPECT_LT(path[0].length_m * path[1].length_m, 0.0);
}

// A centimetre aside is a turn by a degree: no reason to turn the wheels by sixty.
TEST(GentleArcsToPoint, LeadBackAtFirstAndTurnNoSharperThanAMetre) {
  const Nominal nominal = NominalRover();
  for (const double aside_m : {0.009, 0.02, -0.03}) {
    const Eigen::Vector2d goal = nominal.plan.p_RP + Eigen::Vector2d(0.004, aside_m);
    const std::vector<Arc> path = GentleArcsToPoint(goal, nominal.plan);
    ASSERT_EQ(path.size(), 2u);
    EXPECT_LE(path[0].length_m, -0.09);
    for (const Arc& arc : path) {
      EXPECT_GE(std::abs(arc.length_m), 0.999 * std::abs(arc.turn_rad));
    }
    EXPECT_LT((Advance({}, path) * nominal.plan.p_RP - goal).norm(), 1e-9);
  }
}

// Wheels that spin in their holes: image pairs differ by what they err.
TEST(Retreat, BeginsFarAwayWhereTheRoverIsStuck) {
  Retreat retreat;
  for (const double off_m : {0.95, 0.90, 0.85, 0.84, 0.845, 0.838}) {
    EXPECT_FALSE(retreat.Decide(off_m, 0.25, 3)) << off_m;
  }
  EXPECT_TRUE(retreat.Decide(0.843, 0.25, 3));
}

TEST(Retreat, BeginsAfterThreeLooksThatCameNoNearerAndTakesTurnsAside) {
  Retreat retreat;
  EXPECT_FALSE(retreat.Decide(0.5, 0.25, 3));
  EXPECT_FALSE(retreat.Decide(0.10, 0.25, 3));
  EXPECT_FALSE(retreat.Decide(0.05, 0.25, 3));
  EXPECT_FALSE(retreat.Decide(0.05, 0.25, 3));
  EXPECT_FALSE(retreat.Decide(0.06, 0.25, 3));
  std::vector<double> ends_m;
  for (int time = 0; time < 2; ++time) {
    std::vector<Arc> path;
    while (retreat.Decide(0.05, 0.25, 3)) path.push_back(retreat.Next());
    const Pose2 end = Advance({}, path);
    EXPECT_LT(end.x, -0.55);
    EXPECT_NEAR(end.heading, 0.0, 1e-12);
    ends_m.push_back(end.y);
    for (int pair = 0; pair < 2; ++pair) EXPECT_FALSE(retreat.Decide(0.05, 0.25, 3));
  }
  EXPECT_GT(std::abs(ends_m[0]), 0.05);
  EXPECT_NEAR(ends_m[0], -ends_m[1], 1e-12);
}

Obstacles DiscAt(double x, double y) {
  Obstacles obstacles;
  obstacles.discs.push_back({{x, y}, 0.03});
  return obstacles;
}

std::vector<Arc> RetreatBefore(const Obstacles& behind_R) {
  const Nominal nominal = NominalRover();
  Retreat retreat;
  for (int pair = 0; pair < 4; ++pair) retreat.Decide(0.05, 0.25, 3);
  std::vector<Arc> path;
  retreat.KeepOff(nominal.plan, behind_R);
  while (retreat.HasArcs()) path.push_back(retreat.Next());
  return path;
}

// The left wheels' track is 0.2 m to the left: what lies to its left, behind, blocks the retreat
// to the left alone. It stops before an obstacle in each track.
TEST(Retreat, KeepsOffWhatIsBehind) {
  const std::vector<Arc> free = RetreatBefore({});
  ASSERT_EQ(free.size(), 4u);
  const double aside_m = Advance({}, free).y;
  const double at_m = std::copysign(0.30, aside_m);
  const std::vector<Arc> other = RetreatBefore(DiscAt(-0.7, at_m));
  ASSERT_EQ(other.size(), 4u);
  EXPECT_NEAR(Advance({}, other).y, -aside_m, 1e-12);
  Obstacles both = DiscAt(-0.65, 0.2);
  both.discs.push_back({{-0.65, -0.2}, 0.03});
  const std::vector<Arc> some = RetreatBefore(both);
  ASSERT_THAT(some.size(), testing::AllOf(testing::Ge(1u), testing::Lt(4u)));
  EXPECT_GT(Clearance(NominalRover().plan, some, both, 1.0), 0.0);
  EXPECT_TRUE(RetreatBefore(DiscAt(-0.18, 0.2)).empty());
}

SensorFrame Frame(Tick tick) {
  SensorFrame frame;
  frame.tick = tick;
  frame.motors.resize(12);
  return frame;
}

TEST(Approach, GivesUpWhenTheCamerasDoNotAnswer) {
  const auto controller = MakeDockyardController(NominalRover());
  int asks = 0;
  Tick tick = 0;
  for (; tick < 60000; tick += kControlPeriod) {
    const Commands commands = controller->Step(Frame(tick));
    asks += !commands.take_images.empty();
    if (commands.verdict == Verdict::kGivenUp) break;
  }
  EXPECT_EQ(asks, 5);
  EXPECT_EQ(tick, 15000);
  EXPECT_THAT(controller->belief().note, HasSubstr("cameras do not answer"));
}

TEST(Approach, SaysThatNothingIsSeenWhereTheUserClicked) {
  const auto controller = MakeDockyardController(NominalRover());
  EXPECT_FALSE(controller->Step(Frame(0)).take_images.empty());
  SensorFrame frame = Frame(kControlPeriod);
  const GrayImage blank{640, 480, std::vector<std::uint8_t>(640 * 480, 90)};
  frame.images = {{kFrontLeft, blank, 0}, {kFrontRight, blank, 0}};
  const Commands commands = controller->Step(frame);
  EXPECT_EQ(commands.verdict, Verdict::kGivenUp);
  EXPECT_THAT(controller->belief().note, HasSubstr("no range data where the user clicked"));
}

}  // namespace
}  // namespace dockyard::rocky7
