#include "controller/rocky7/mast_drive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

// Joints that follow their trapezoids, without ramps; a held one does not move.
struct Joints {
  Nominal nominal = NominalRover();
  MastAngles angles = nominal.mast.watch_rad;
  Tick tick = 0;

  SensorFrame Frame() const {
    SensorFrame frame;
    frame.tick = tick;
    frame.motors.resize(nominal.motors.size());
    for (std::size_t i = 0; i < angles.size(); ++i) {
      frame.motors[FirstMastMotor(nominal) + i].encoder_counts = std::llround(angles[i] / 1e-4);
    }
    return frame;
  }
  void Obey(const std::vector<MotorCommand>& commands, std::size_t held = 99) {
    for (std::size_t i = 0; i < angles.size(); ++i) {
      if (commands[i].mode != MotorMode::kPosition || i == held) continue;
      const double step = commands[i].speed_limit_rad_s * kControlPeriod * kTickSeconds;
      angles[i] += std::clamp(commands[i].target - angles[i], -step, step);
    }
    tick += kControlPeriod;
  }
};

const MastAngles kGoal{0.6, -1.1, 1.2};

TEST(MastDrive, IsBrakedUntilItsFirstMove) {
  const Joints joints;
  const MastDrive drive(joints.nominal);
  for (const MotorCommand& command : drive.commands()) {
    EXPECT_EQ(command.mode, MotorMode::kBrake);
  }
}

// Each joint at the speed that takes it there in the time of the one with the longest move.
TEST(MastDrive, AllJointsTakeTheSameTime) {
  const Joints joints;
  MastDrive drive(joints.nominal);
  drive.Begin(kGoal, 0.5, joints.Frame());
  const MastAngles now = drive.Angles(joints.Frame());
  double longest_s = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest_s = std::max(longest_s, std::abs(kGoal[i] - now[i]) / (0.5 * 0.3));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::abs(kGoal[i] - now[i]) / drive.commands()[i].speed_limit_rad_s, longest_s,
                1e-9);
    EXPECT_EQ(drive.commands()[i].target, kGoal[i]);
  }
}

TEST(MastDrive, RestsWhenTheMastHasSwungOut) {
  Joints joints;
  MastDrive drive(joints.nominal);
  drive.Begin(kGoal, 1.0, joints.Frame());
  Tick arrived = -1;
  while (!drive.Rests(joints.Frame()) && joints.tick < 60000) {
    joints.Obey(drive.commands());
    double off_rad = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      off_rad = std::max(off_rad, std::abs(kGoal[i] - joints.angles[i]));
    }
    if (arrived < 0 && off_rad < Radians(0.2)) arrived = joints.tick;
  }
  EXPECT_GE(joints.tick - arrived, 800);
  EXPECT_LE(joints.tick - arrived, 800 + 2 * kControlPeriod);
  EXPECT_FALSE(drive.Missed(joints.Frame()));
}

TEST(MastDrive, LeavesAJointThatIsHeldAndSaysSo) {
  Joints joints;
  MastDrive drive(joints.nominal);
  drive.Begin(kGoal, 1.0, joints.Frame());
  while (!drive.Rests(joints.Frame()) && joints.tick < 60000) joints.Obey(drive.commands(), 1);
  EXPECT_LT(joints.tick, 10000);
  EXPECT_TRUE(drive.Missed(joints.Frame()));
}

}  // namespace
}  // namespace dockyard::rocky7
