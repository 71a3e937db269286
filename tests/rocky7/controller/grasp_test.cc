#include "controller/rocky7/grasp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

/// Drives that go to their targets, unless the test blocks them.
class ArmRig {
 public:
  explicit ArmRig(const Nominal& nominal, bool ground_as_body = false)
      : nominal_(nominal), grasp(nominal, ground_as_body) {
    rad_[1] = -1.4;
    rad_[2] = rad_[3] = -1.57;
  }

  void Step() {
    SensorFrame frame;
    frame.tick = tick_;
    frame.imu.pitch_rad = pitch_rad;
    frame.motors.resize(12);
    for (std::size_t i = 0; i < 4; ++i) {
      frame.motors[8 + i] = {std::llround(rad_[i] / nominal_.motors[8 + i].rad_per_count),
                             current_a[i]};
    }
    if (tick_ == 0) grasp.Start(frame, weighs, aside_m);
    if (!lifted()) Follow(Task::kGrasp, grasp.Step(phase, frame), phase);
    const std::vector<MotorCommand>& commands = grasp.commands();
    const double was_rad = rad_[1];
    for (std::size_t i = 0; i < 4; ++i) {
      if (commands[i].mode != MotorMode::kPosition) continue;
      const double step = commands[i].speed_limit_rad_s * kControlPeriod * kTickSeconds;
      rad_[i] += std::clamp(commands[i].target - rad_[i], -step, step);
    }
    // What lies between the scoops keeps them apart.
    const double apart = rad_[3] - rad_[2];
    if (apart < least_open_rad) {
      rad_[3] += 0.5 * (least_open_rad - apart);
      rad_[2] -= 0.5 * (least_open_rad - apart);
    }
    resists = apart < least_open_rad + 1e-9;
    if (in_ground && rad_[3] - rad_[2] < holds_below_rad) rad_[1] = std::max(rad_[1], was_rad);
    tick_ += kControlPeriod;
  }
  /// Of both lips in the middle, about the body's y axis.
  double lips_rad() const { return rad_[1] + 0.5 * (rad_[2] + rad_[3]); }
  bool lifted() const { return phase == Phase::kLifted; }
  /// Of the scoops' axis over ground that is parallel to the body.
  double height_m() const { return 0.13 + 0.07 - 0.32 * std::sin(rad_[1]) * std::cos(rad_[0]); }
  /// Of the lips, 5 cm below the axis, to the left of the arm.
  double lips_aside_m() const { return (0.32 * std::sin(rad_[1]) + 0.05) * std::sin(rad_[0]); }
  double seconds() const { return static_cast<double>(tick_) * kTickSeconds; }

 private:
  Nominal nominal_;
  std::array<double, 4> rad_{};
  Tick tick_ = 0;

 public:
  Grasp grasp;
  Phase phase = Phase::kDeploy;
  bool weighs = false;
  double pitch_rad = 0.0;  // of the body
  double aside_m = 0.0;    // of the target
  std::array<double, 4> current_a{0.1, 0.5, 0.1, 0.1};
  double least_open_rad = 0.0;
  bool resists = false;
  bool in_ground = false;        // what the scoops hold does not rise
  double holds_below_rad = 0.3;  // with the scoops open by less
};

TEST(Grasp, GoesDownToTheGroundShutsAndLiftsWithoutAStone) {
  ArmRig rig(NominalRover());
  double lowest_m = 1.0;
  while (!rig.lifted() && rig.seconds() < 60.0) {
    rig.Step();
    lowest_m = std::min(lowest_m, rig.height_m());
  }
  EXPECT_TRUE(rig.lifted());
  EXPECT_NEAR(lowest_m, 0.03, 0.003);
  EXPECT_GT(rig.height_m(), 0.28);
  EXPECT_EQ(rig.grasp.note(), "the scoops are shut");
}

// On a slope of 10 deg, downhill and uphill.
TEST(Grasp, GoesDownToGroundThatIsParallelToTheBody) {
  for (const double pitch_rad : {0.17, -0.17}) {
    ArmRig rig(NominalRover(), true);
    rig.pitch_rad = pitch_rad;
    double lowest_m = 1.0;
    while (!rig.lifted() && rig.seconds() < 60.0) {
      rig.Step();
      lowest_m = std::min(lowest_m, rig.height_m());
    }
    EXPECT_TRUE(rig.lifted());
    EXPECT_NEAR(lowest_m, 0.03, 0.003) << pitch_rad;
    // The lips are below the axis, upright on the ground.
    EXPECT_NEAR(rig.lips_rad(), 0.0, 1e-9);
  }
}

// With the roll, turned about the body's x axis, the lips come down on a target to a side; the arm
// carries it level.
TEST(Grasp, RollsTheArmToATargetAside) {
  for (const double aside_m : {0.03, -0.02}) {
    ArmRig rig(NominalRover());
    rig.aside_m = aside_m;
    double closest_m = 1.0, lowest_m = 1.0;
    while (!rig.lifted() && rig.seconds() < 60.0) {
      rig.Step();
      if (rig.height_m() < lowest_m) closest_m = std::abs(rig.lips_aside_m() - aside_m);
      lowest_m = std::min(lowest_m, rig.height_m());
    }
    EXPECT_LT(closest_m, 0.004) << aside_m;
    EXPECT_NEAR(lowest_m, 0.03, 0.005);
    EXPECT_NEAR(rig.lips_aside_m(), 0.0, 1e-9);
  }
}

TEST(Grasp, StopsGoingDownWhereThePitchMotorsCurrentRises) {
  ArmRig rig(NominalRover());
  double lowest_m = 1.0;
  while (rig.phase != Phase::kClose && rig.seconds() < 60.0) {
    rig.current_a[1] = rig.height_m() < 0.06 ? 1.2 : 0.5;
    rig.Step();
    lowest_m = std::min(lowest_m, rig.height_m());
  }
  EXPECT_NEAR(lowest_m, 0.06, 0.004);
}

TEST(Grasp, RaisesTheArmWhileScoopsThatResistClose) {
  ArmRig rig(NominalRover());
  rig.least_open_rad = 0.5;
  double lowest_m = 1.0, at_lift_m = 0.0;
  while (!rig.lifted() && rig.seconds() < 60.0) {
    rig.current_a[2] = rig.current_a[3] = rig.resists ? 1.1 : 0.1;
    rig.Step();
    lowest_m = std::min(lowest_m, rig.height_m());
    if (rig.phase == Phase::kClose) at_lift_m = rig.height_m();
  }
  EXPECT_TRUE(rig.lifted());
  EXPECT_EQ(rig.grasp.note(), "the scoops came to rest");
  // 0.12 rad of raising, at the arm's pitch.
  EXPECT_NEAR(at_lift_m - lowest_m, 0.12 * 0.32 * 0.87, 0.008);
}

// The arm's motor draws more once the scoops have closed.
TEST(Grasp, WeighsWhatTheScoopsHaveBroughtUp) {
  for (const bool holds : {true, false}) {
    ArmRig rig(NominalRover());
    rig.weighs = true;
    bool closed = false;
    while (!rig.lifted() && rig.seconds() < 60.0) {
      closed = closed || rig.phase == Phase::kClose;
      rig.current_a[1] = closed && holds ? 0.54 : 0.5;
      rig.Step();
    }
    EXPECT_TRUE(rig.lifted());
    EXPECT_EQ(rig.grasp.load(), holds ? Load::kStone : Load::kNone);
  }
}

TEST(Grasp, OpensScoopsThatHoldSomethingThatDoesNotRise) {
  ArmRig rig(NominalRover());
  rig.weighs = rig.in_ground = true;
  while (rig.phase != Phase::kObserve && rig.seconds() < 60.0) rig.Step();
  EXPECT_EQ(rig.phase, Phase::kObserve);
  EXPECT_GT(rig.height_m(), 0.28);
}

TEST(Grasp, GivesUpWhereTheArmDoesNotComeUp) {
  ArmRig rig(NominalRover());
  rig.weighs = true;
  while (!IsOver(rig.phase) && rig.seconds() < 90.0) {
    rig.in_ground = rig.phase == Phase::kLift;
    rig.holds_below_rad = 10.0;
    rig.Step();
  }
  EXPECT_EQ(rig.phase, Phase::kGivenUp);
}

// A motor whose current reads zero feels neither stone nor ground: nothing else tells.
TEST(Grasp, WithoutCurrentsNeverRaises) {
  ArmRig rig(NominalRover());
  rig.least_open_rad = 0.5;
  rig.current_a = {};
  double lowest_m = 1.0, at_lift_m = 0.0;
  while (!rig.lifted() && rig.seconds() < 60.0) {
    rig.Step();
    lowest_m = std::min(lowest_m, rig.height_m());
    if (rig.phase == Phase::kClose) at_lift_m = rig.height_m();
  }
  EXPECT_NEAR(at_lift_m, lowest_m, 1e-3);
}

}  // namespace
}  // namespace dockyard::rocky7
