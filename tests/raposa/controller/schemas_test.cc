// Motor schemas, the visual turn and the search.
#include "controller/raposa/schemas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "controller/geometry/pose.h"
#include "controller/raposa/align_plan.h"
#include "controller/raposa/search.h"
#include "controller/raposa/visual_turn.h"

namespace dockyard::raposa {
namespace {

constexpr FerreiraMotion kSpeeds;

MarksSeen OrangeAt(double distance_m, double right_px = 0.0, double down_px = 0.0) {
  MarksSeen seen;
  seen.orange = OrangeMark{.ellipse = {}, .area_px2 = 100.0, .distance_m = distance_m};
  seen.deviation_px = {right_px, down_px};
  return seen;
}

TEST(Schemas, SpeedIsConstantBeyondAMetreAndFallsWithTheDistance) {
  EXPECT_NEAR(Approach(OrangeAt(2.0), kSpeeds).speed_m_s, 0.082, 1e-12);
  EXPECT_NEAR(Approach(OrangeAt(1.0), kSpeeds).speed_m_s, 0.082, 1e-12);
  EXPECT_NEAR(Approach(OrangeAt(0.5), kSpeeds).speed_m_s, 0.041, 1e-12);
  // State 6 goes on as state 1 ended.
  EXPECT_NEAR(FinalApproach(OrangeAt(0.3), kSpeeds).speed_m_s,
              Approach(OrangeAt(0.3), kSpeeds).speed_m_s, 0.05 * kSpeeds.final_speed_m_s);
}

TEST(Schemas, TheRobotTurnsToTheEllipse) {
  EXPECT_LT(Approach(OrangeAt(1.0, 20.0), kSpeeds).turn_rad_s, 0.0);  // right: clockwise
  EXPECT_GT(Approach(OrangeAt(1.0, -20.0), kSpeeds).turn_rad_s, 0.0);
  FerreiraMotion blind = kSpeeds;
  blind.steer_final = false;
  EXPECT_EQ(FinalApproach(OrangeAt(0.2, 20.0), blind).turn_rad_s, 0.0);
  EXPECT_EQ(FinalApproach({}, kSpeeds).turn_rad_s, 0.0);
}

TEST(Schemas, AGuideLowInTheImageLowersTheBack) {
  EXPECT_GT(ArmFor(OrangeAt(0.4, 0.0, 30.0), kSpeeds), 0.0);  // tip down: the back goes down
  EXPECT_NEAR(ArmFor(OrangeAt(0.4, 0.0, 60.0), kSpeeds), 0.12, 1e-12);
  EXPECT_EQ(ArmFor(OrangeAt(0.4, 0.0, 500.0), kSpeeds), kSpeeds.most_arm_rad);
  EXPECT_EQ(ArmFor(OrangeAt(0.4, 0.0, -30.0), kSpeeds), kSpeeds.least_arm_rad);
  EXPECT_TRUE(NearGuide(OrangeAt(0.44), kSpeeds));
  EXPECT_FALSE(NearGuide(OrangeAt(0.46), kSpeeds));
  EXPECT_FALSE(NearGuide({}, kSpeeds));
}

TEST(Schemas, TheTurnAboutBlueCarriesItOverTheView) {
  TurnAboutBlue turn;
  double blue_px = 40.0, least = blue_px, most = blue_px;
  for (int i = 0; i < 400; ++i) {
    blue_px += 377.0 * 0.1 * turn.Step(blue_px, 83.0, kSpeeds);
    least = std::min(least, blue_px);
    most = std::max(most, blue_px);
  }
  EXPECT_NEAR(least, -0.6 * 83.0, 3.0);
  EXPECT_NEAR(most, 0.6 * 83.0, 3.0);
}

/// Turns a robot that sees the guide with that delay, in frames. The bearing at the end of all
/// motion and the turn are the result.
struct TurnedRobot {
  double turned_rad = 0.0, bearing_rad = 0.0, believed_rad = 0.0;
  int frames = 0;
};
TurnedRobot TurnWith(double turn_rad, double edge_rad, int delay, double lever_m = 0.0) {
  const double range_m = 1.33 + lever_m;
  VisualTurn turn(turn_rad, 0.0, range_m, lever_m, kSpeeds);
  std::vector<double> bearings{0.0};
  const auto bearing_at = [&](double turned) {
    return std::atan2(range_m * std::sin(turned), range_m * std::cos(turned) - lever_m);
  };
  TurnedRobot robot;
  for (; robot.frames < 300; ++robot.frames) {
    const int seen = std::max(0, static_cast<int>(bearings.size()) - 1 - delay);
    const auto twist =
        turn.Step(VisualTurn::Look{bearings[static_cast<std::size_t>(seen)], edge_rad});
    if (!twist) break;
    robot.turned_rad += 0.1 * twist->turn_rad_s;
    bearings.push_back(bearing_at(robot.turned_rad));
  }
  robot.bearing_rad = bearings.back();
  robot.believed_rad = turn.turned_rad();
  return robot;
}

TEST(VisualTurn, EndsAtItsAngleInsideTheView) {
  for (const double turn_rad : {0.12, -0.12}) {
    const TurnedRobot robot = TurnWith(turn_rad, Radians(12.0), 1);
    EXPECT_NEAR(robot.turned_rad, turn_rad, 0.1 * kSpeeds.visual_turn_rad_s + 1e-9);
    EXPECT_NEAR(robot.believed_rad, robot.turned_rad, 1e-9);
    EXPECT_NEAR(0.1 * robot.frames, 0.12 / kSpeeds.visual_turn_rad_s, 0.25);
  }
}

// "To prevent the loss of the ellipse ... due to the delay on the control cycle" (F, C.3).
TEST(VisualTurn, ThePredictorKeepsTheEllipseInViewThroughADelay) {
  const double edge = Radians(12.0), frame = 0.1 * kSpeeds.visual_turn_rad_s;
  const TurnedRobot prompt = TurnWith(0.6, edge, 0);
  EXPECT_LE(prompt.bearing_rad, edge + 1e-9);
  // A picture that is a frame old: what it predicts has come true.
  const TurnedRobot late = TurnWith(0.6, edge, 1);
  EXPECT_LE(late.bearing_rad, edge + frame);
  EXPECT_GT(late.bearing_rad, edge - frame);
  EXPECT_NEAR(late.believed_rad, late.turned_rad, 1e-9);
}

TEST(VisualTurn, KnowsThatTheCameraIsNotAtTheTurningCentre) {
  const TurnedRobot robot = TurnWith(0.12, Radians(12.0), 1, 0.28);
  EXPECT_NEAR(robot.turned_rad, 0.12, 0.1 * kSpeeds.visual_turn_rad_s + 1e-9);
  EXPECT_GT(robot.bearing_rad, 1.15 * robot.turned_rad);
}

TEST(VisualTurn, StopsWhileTheEllipseIsLost) {
  VisualTurn turn(0.6, 0.0, 1.0, 0.0, kSpeeds);
  EXPECT_EQ(turn.Step(VisualTurn::Look{0.0, 0.2})->turn_rad_s, kSpeeds.visual_turn_rad_s);
  EXPECT_EQ(turn.Step(std::nullopt)->turn_rad_s, 0.0);
  // Back at another place: the jump is no speed.
  EXPECT_TRUE(turn.Step(VisualTurn::Look{0.12, 0.2}));
}

TEST(VisualTurn, TheRoundViewIsNarrowerOffItsMiddle) {
  EXPECT_NEAR(EdgeBearing(Radians(12.5), 377.0, 0.0, 0.0), Radians(12.5), 1e-12);
  const double low = EdgeBearing(Radians(12.5), 377.0, 60.0, 5.0);
  const double view_px = 377.0 * std::tan(Radians(12.5));
  EXPECT_NEAR(377.0 * std::tan(low), std::sqrt(view_px * view_px - 3600.0) - 5.0, 1e-9);
  EXPECT_EQ(EdgeBearing(Radians(12.5), 377.0, 200.0, 5.0), 0.0);
}

// The widest reach to either side: 20, then 40 - 20, 80 - 20, 160 - 60 ... deg.
TEST(WideningSearch, DoublesItsAngleAtEachSwitch) {
  WideningSearch search(kSpeeds);
  search.Begin(-0.3);  // the last rotation was to the right
  std::vector<double> switches;
  double heading = 0.0, rate = 0.0;
  for (int i = 0; i < 20'000 && switches.size() < 7; ++i) {
    const double now = search.Step(0.1 * rate);
    if (rate != 0.0 && now * rate < 0.0) switches.push_back(Degrees(heading));
    if (i == 0) {
      EXPECT_GT(now, 0.0);
    }
    rate = now;
    heading += 0.1 * rate;
  }
  const std::vector<double> expected{20, -20, 60, -100, 220, -130, 220};
  ASSERT_EQ(switches.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(switches[i], expected[i], 2.5);
}

TEST(WideningSearch, BeginsOppositeToTheLastRotation) {
  WideningSearch search(kSpeeds);
  search.Begin(0.5);
  EXPECT_LT(search.Step(0.0), 0.0);
  search.Begin(-0.5);
  EXPECT_GT(search.Step(0.0), 0.0);
}

}  // namespace
}  // namespace dockyard::raposa
