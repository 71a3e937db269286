// Odometry, the plan of region II and the laws that drive it, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/motion/arcs.h"
#include "controller/raposa/align_plan.h"
#include "controller/raposa/odometry.h"
#include "controller/raposa/way_control.h"
#include "raposa/controller/drawn_marks.h"
#include "sim/base/random.h"

namespace dockyard::raposa {
namespace {

const Nominal kNominal = TestNominal();
constexpr FerreiraMotion kOptions;

SensorFrame FrameAt(double left_rad, double right_rad) {
  SensorFrame frame;
  frame.motors.resize(kMotorCount);
  frame.motors[0].encoder_counts = std::llround(left_rad / kNominal.motors[0].rad_per_count);
  frame.motors[1].encoder_counts = std::llround(right_rad / kNominal.motors[1].rad_per_count);
  return frame;
}

TEST(BeltOdometry, BeltsThatCountDownApproach) {
  BeltOdometry odometry(kNominal);
  odometry.Update(FrameAt(3.0, 3.0));  // the first reading is no motion
  const BeltMotion motion = odometry.Update(FrameAt(2.0, 2.0));
  EXPECT_NEAR(motion.length_m, 0.09, 1e-9);
  EXPECT_NEAR(motion.turn_rad, 0.0, 1e-12);
  EXPECT_NEAR(odometry.X_ON().x, 0.09, 1e-9);
}

// (9): the belts' way in a full turn is the effective gauge's circle.
TEST(BeltOdometry, OneTurnInPlaceIsTheGaugesCircle) {
  BeltOdometry odometry(kNominal);
  odometry.Update(FrameAt(0.0, 0.0));
  const double way_rad = 2.0 * kPi * 0.5 * 0.577 / 0.09;
  double turned = 0.0;
  for (int i = 1; i <= 20; ++i) {
    turned += odometry.Update(FrameAt(-way_rad * i / 20, way_rad * i / 20)).turn_rad;
  }
  EXPECT_NEAR(turned, 2.0 * kPi, 1e-4);
  EXPECT_NEAR(odometry.X_ON().x, 0.0, 1e-9);
}

TEST(BeltOdometry, SpeedsAndMotionAreInverse) {
  const Twist twist{0.08, -0.2};
  const BeltSpeeds speeds = SpeedsOfBelts(kNominal, twist);
  const BeltMotion motion = MotionOfBelts(kNominal, speeds.left_rad_s, speeds.right_rad_s);
  EXPECT_NEAR(motion.length_m, twist.speed_m_s, 1e-12);
  EXPECT_NEAR(motion.turn_rad, twist.turn_rad_s, 1e-12);
}

TEST(BeltOdometry, ResetKeepsTheTurnedAngleAlone) {
  BeltOdometry odometry(kNominal);
  odometry.Update(FrameAt(0.0, 0.0));
  odometry.Update(FrameAt(-4.0, -1.0));
  odometry.Reset(0.3);
  EXPECT_EQ(odometry.X_ON(), (Pose2{0.0, 0.0, 0.3}));
}

// raposa.md 2: D and sin beta of a robot that is one point, and phi = alpha + beta back.
TEST(AlignPlan, IsThePapersFigureWithoutALever) {
  const double delta = 0.6;
  for (const double r : {0.7, 1.33, 2.0}) {
    for (const double alpha_deg : {-60.0, -20.0, 30.0, 60.0, 75.0}) {  // none lies behind
      const double alpha = Radians(alpha_deg);
      const AlignPlan plan = PlanAlignment({r, alpha, 0.0}, delta, 0.0);
      const double way = std::sqrt(r * r + delta * delta - 2 * r * delta * std::cos(alpha));
      EXPECT_NEAR(plan.way_m, way, 1e-12);
      EXPECT_NEAR(std::sin(plan.beta_rad), delta * std::sin(alpha) / way, 1e-12);
      EXPECT_NEAR(plan.phi_rad, -(alpha + plan.beta_rad), 1e-12);
    }
  }
}

// Table in raposa.md 2: r 0.5, alpha 60 deg.
TEST(AlignPlan, BetaOfThePointsNearAndAside) {
  const double beta_deg[] = {60, 69, 76, 82, 86, 90};
  for (int i = 0; i < 6; ++i) {
    const AlignPlan plan = PlanAlignment({0.5, Radians(60.0), 0.0}, 0.5 + 0.1 * i, 0.0);
    EXPECT_NEAR(Degrees(std::abs(plan.beta_rad)), beta_deg[i], 0.5);
  }
}

/// The pose at the plan's end in P, driven from the guide's true place.
Pose2 EndInP(const AlignPlan& plan, const GuidePlace& truth, double lever_m) {
  return PoseOfN(truth, lever_m) *
         Advance(Pose2{}, {Arc{0.0, plan.beta_rad}, Arc{plan.way_m, 0.0}, Arc{0.0, plan.phi_rad}});
}

TEST(AlignPlan, EndsOnTheAxisFacingTheGuide) {
  RandomStream random(StreamKey(3, "places"));
  for (int i = 0; i < 300; ++i) {
    const GuidePlace guide{random.Uniform(0.35, 2.5), random.Uniform(-1.9, 1.9),
                           random.Uniform(-0.2, 0.2)};
    const double lever = i % 2 == 0 ? 0.0 : 0.28;
    const AlignPlan plan = PlanAlignment(guide, 0.6, lever);
    const Pose2 end = EndInP(plan, guide, lever);
    EXPECT_NEAR(end.x, 0.6 + lever, 1e-9);
    EXPECT_NEAR(end.y, 0.0, 1e-9);
    EXPECT_NEAR(WrapPi(end.heading - kPi), 0.0, 1e-9);
    EXPECT_LE(std::abs(plan.beta_rad), 0.5 * kPi + 1e-9);
  }
}

TEST(AlignPlan, ReversesToAPlaceBehind) {
  // delta > r / cos alpha: the place lies farther out, past a quarter turn.
  const AlignPlan plan = PlanAlignment({0.4, Radians(30.0), 0.0}, 0.6, 0.0);
  EXPECT_LT(plan.way_m, 0.0);
  EXPECT_LT(plan.beta_rad, 0.0);
  EXPECT_GT(PlanAlignment({0.8, Radians(30.0), 0.0}, 0.6, 0.0).way_m, 0.0);
}

// "Angles lower than about 110 deg" (F, C.2): a plan with a wrong estimate is the right one turned
// about the pyramid, so it ends at alpha - estimate, at delta, facing the guide.
TEST(AlignPlan, AWrongEstimateEndsAtAlphaLessTheEstimate) {
  for (const double alpha_deg : {80.0, 90.0, 100.0, 109.0, 110.0}) {
    const double estimate_deg = 146.0 - alpha_deg;  // the minus root, continued
    const AlignPlan plan = PlanAlignment({1.5, Radians(estimate_deg), 0.0}, 0.6, 0.0);
    const Pose2 end = EndInP(plan, {1.5, Radians(alpha_deg), 0.0}, 0.0);
    const double ends_deg = Degrees(std::atan2(end.y, end.x));
    EXPECT_NEAR(ends_deg, alpha_deg - estimate_deg, 1e-9);
    EXPECT_NEAR(std::hypot(end.x, end.y), 0.6, 1e-9);
    EXPECT_NEAR(WrapPi(end.heading - kPi - Radians(ends_deg)), 0.0, 1e-9);
    EXPECT_EQ(ends_deg < 73.0, alpha_deg < 109.5);  // 14, 34, 54, 72 and 74 deg
  }
}

TEST(AlignPlan, ALeverMovesTheGuideFurtherThanTheRobotTurns) {
  const double lever = 0.28, range = 0.78;
  EXPECT_DOUBLE_EQ(TurnOfBearing(0.2, range, 0.0), 0.2);
  for (const double turn : {-0.3, 0.05, 0.15}) {
    // Ahead of the turning centre, seen from the camera after that turn to the left.
    const Eigen::Vector2d seen(range * std::cos(turn) - lever, range * std::sin(turn));
    EXPECT_NEAR(TurnOfBearing(std::atan2(seen.y(), seen.x()), range, lever), turn, 1e-12);
  }
}

/// Drives the plan by DriveTo from a pose in O; the robot follows at once.
Pose2 Driven(const AlignPlan& plan, Pose2 X_ON, double* seconds) {
  *seconds = 0.0;
  while (!Arrived(plan, X_ON, kOptions) && *seconds < 120.0) {
    const Twist twist = DriveTo(plan, X_ON, kOptions);
    EXPECT_LE(std::abs(twist.speed_m_s), kOptions.travel_m_s + 1e-12);
    EXPECT_LE(std::abs(twist.turn_rad_s), kOptions.turn_rad_s + 1e-12);
    X_ON = Advance(X_ON, Arc{0.1 * twist.speed_m_s, 0.1 * twist.turn_rad_s});
    *seconds += 0.1;
  }
  return X_ON;
}

TEST(WayControl, DrivesTheWayAtItsSpeedEitherWay) {
  for (const GuidePlace& guide :
       {GuidePlace{1.33, Radians(30.0), 0.0}, GuidePlace{0.4, Radians(30.0), 0.0}}) {
    const AlignPlan plan = PlanAlignment(guide, 0.6, 0.0);
    double seconds = 0.0;
    const Pose2 end = Driven(plan, {0.0, 0.0, plan.beta_rad}, &seconds);
    EXPECT_NEAR(end.x, plan.X_OE.x, kOptions.way_tolerance_m + 1e-3);
    EXPECT_NEAR(end.y, plan.X_OE.y, kOptions.way_tolerance_m + 1e-3);
    EXPECT_NEAR(end.heading, plan.beta_rad, 1e-6);
    // At most the speed, then slower over the last travel_m_s / way_gain.
    EXPECT_GT(seconds, (std::abs(plan.way_m) - 0.03) / kOptions.travel_m_s);
    EXPECT_LT(seconds, std::abs(plan.way_m) / kOptions.travel_m_s + 2.0);
  }
}

// "The possibility of correcting some orientation error in the middle step" (F, D).
TEST(WayControl, CorrectsAHeadingErrorOnTheWay) {
  for (const double alpha_deg : {30.0, -45.0}) {
    const AlignPlan plan = PlanAlignment({1.33, Radians(alpha_deg), 0.0}, 0.6, 0.0);
    double seconds = 0.0;
    const Pose2 end = Driven(plan, {0.0, 0.0, plan.beta_rad + Radians(15.0)}, &seconds);
    const double aside = -(end.x - plan.X_OE.x) * std::sin(plan.beta_rad) +
                         (end.y - plan.X_OE.y) * std::cos(plan.beta_rad);
    EXPECT_NEAR(aside, 0.0, 0.02);  // uncorrected: 0.22 m
    // The point ahead runs straight to its goal, and the heading follows that line.
    const double line = std::asin(kOptions.lead_m * std::sin(Radians(15.0)) / plan.way_m);
    EXPECT_NEAR(end.heading - plan.beta_rad, -line, Radians(1.0));
  }
}

TEST(WayControl, ScalesSpeedAndTurnAlike) {
  const AlignPlan plan = PlanAlignment({1.33, Radians(30.0), 0.0}, 0.6, 0.0);
  const Pose2 X_ON{0.0, 0.0, plan.beta_rad + 0.4};
  FerreiraMotion free = kOptions;
  free.travel_m_s = free.turn_rad_s = 1e9;
  const Twist wanted = DriveTo(plan, X_ON, free), scaled = DriveTo(plan, X_ON, kOptions);
  EXPECT_LT(scaled.speed_m_s, 0.5 * wanted.speed_m_s);
  EXPECT_NEAR(scaled.turn_rad_s / scaled.speed_m_s, wanted.turn_rad_s / wanted.speed_m_s, 1e-12);
}

TEST(WayControl, ATurnEndsWithinItsTolerance) {
  double left = Radians(70.0), seconds = 0.0;
  while (!Turned(left, kOptions)) {
    left -= 0.1 * TurnBy(left, kOptions).turn_rad_s;
    seconds += 0.1;
    ASSERT_LT(seconds, 20.0);
  }
  EXPECT_GT(left, -1e-12);
  EXPECT_NEAR(seconds, Radians(70.0) / kOptions.turn_rad_s, 1.0);
}

}  // namespace
}  // namespace dockyard::raposa
