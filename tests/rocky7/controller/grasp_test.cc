#include "controller/rocky7/grasp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

/// Drives that go to their targets, but for what the test puts in their way.
class ArmStand {
 public:
  explicit ArmStand(const Nominal& nominal, bool ground_as_body = false)
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
    if (tick_ == 0) grasp.Start(frame, weighs);
    if (!lifted()) Follow(Task::kGrasp, grasp.Step(phase, frame), phase);
    const std::vector<MotorCommand>& commands = grasp.commands();
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
    tick_ += kControlPeriod;
  }
  /// Of both lips in the middle, about the body's y axis.
  double lips_rad() const { return rad_[1] + 0.5 * (rad_[2] + rad_[3]); }
  bool lifted() const { return phase == Phase::kLifted; }
  /// Of the scoops' axis over ground that is parallel to the body.
  double height_m() const { return 0.13 + 0.07 - 0.32 * std::sin(rad_[1]); }
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
  std::array<double, 4> current_a{0.1, 0.5, 0.1, 0.1};
  double least_open_rad = 0.0;
  bool resists = false;
};

TEST(Grasp, GoesDownToTheGroundShutsAndLiftsWithoutAStone) {
  ArmStand stand(NominalRover());
  double lowest_m = 1.0;
  while (!stand.lifted() && stand.seconds() < 60.0) {
    stand.Step();
    lowest_m = std::min(lowest_m, stand.height_m());
  }
  EXPECT_TRUE(stand.lifted());
  EXPECT_NEAR(lowest_m, 0.03, 0.003);
  EXPECT_GT(stand.height_m(), 0.28);
  EXPECT_EQ(stand.grasp.note(), "the scoops are shut");
}

// On a slope of 10 deg, downhill and uphill.
TEST(Grasp, GoesDownToGroundThatIsParallelToTheBody) {
  for (const double pitch_rad : {0.17, -0.17}) {
    ArmStand stand(NominalRover(), true);
    stand.pitch_rad = pitch_rad;
    double lowest_m = 1.0;
    while (!stand.lifted() && stand.seconds() < 60.0) {
      stand.Step();
      lowest_m = std::min(lowest_m, stand.height_m());
    }
    EXPECT_TRUE(stand.lifted());
    EXPECT_NEAR(lowest_m, 0.03, 0.003) << pitch_rad;
    // The lips are below the axis, upright on the ground.
    EXPECT_NEAR(stand.lips_rad(), 0.0, 1e-9);
  }
}

TEST(Grasp, StopsGoingDownWhereThePitchMotorsCurrentRises) {
  ArmStand stand(NominalRover());
  double lowest_m = 1.0;
  while (stand.phase != Phase::kClose && stand.seconds() < 60.0) {
    stand.current_a[1] = stand.height_m() < 0.06 ? 1.2 : 0.5;
    stand.Step();
    lowest_m = std::min(lowest_m, stand.height_m());
  }
  EXPECT_NEAR(lowest_m, 0.06, 0.004);
}

TEST(Grasp, RaisesTheArmWhileScoopsThatResistClose) {
  ArmStand stand(NominalRover());
  stand.least_open_rad = 0.5;
  double lowest_m = 1.0, at_lift_m = 0.0;
  while (!stand.lifted() && stand.seconds() < 60.0) {
    stand.current_a[2] = stand.current_a[3] = stand.resists ? 1.1 : 0.1;
    stand.Step();
    lowest_m = std::min(lowest_m, stand.height_m());
    if (stand.phase == Phase::kClose) at_lift_m = stand.height_m();
  }
  EXPECT_TRUE(stand.lifted());
  EXPECT_EQ(stand.grasp.note(), "the scoops came to rest");
  // 0.12 rad of raising, at the arm's pitch.
  EXPECT_NEAR(at_lift_m - lowest_m, 0.12 * 0.32 * 0.87, 0.008);
}

// The arm's motor draws more once the scoops have closed.
TEST(Grasp, WeighsWhatTheScoopsHaveBroughtUp) {
  for (const bool holds : {true, false}) {
    ArmStand stand(NominalRover());
    stand.weighs = true;
    bool closed = false;
    while (!stand.lifted() && stand.seconds() < 60.0) {
      closed = closed || stand.phase == Phase::kClose;
      stand.current_a[1] = closed && holds ? 0.54 : 0.5;
      stand.Step();
    }
    EXPECT_TRUE(stand.lifted());
    EXPECT_EQ(stand.grasp.load(), holds ? Load::kStone : Load::kNone);
  }
}

// A motor whose current reads zero feels neither stone nor ground: nothing else tells.
TEST(Grasp, WithoutCurrentsNeverRaises) {
  ArmStand stand(NominalRover());
  stand.least_open_rad = 0.5;
  stand.current_a = {};
  double lowest_m = 1.0, at_lift_m = 0.0;
  while (!stand.lifted() && stand.seconds() < 60.0) {
    stand.Step();
    lowest_m = std::min(lowest_m, stand.height_m());
    if (stand.phase == Phase::kClose) at_lift_m = stand.height_m();
  }
  EXPECT_NEAR(at_lift_m, lowest_m, 1e-3);
}

}  // namespace
}  // namespace dockyard::rocky7
