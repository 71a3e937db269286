#include "controller/rocky7/arc_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/motion/steering.h"
#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

/// Drives that go to their targets at their speeds, without ramps; a stuck one does not move.
class IdealDrives {
 public:
  explicit IdealDrives(const Nominal& nominal) : nominal_(nominal), rad_(nominal.motors.size()) {}

  SensorFrame Read() const {
    SensorFrame frame;
    frame.tick = tick_;
    for (std::size_t i = 0; i < rad_.size(); ++i) {
      frame.motors.push_back({std::llround(rad_[i] / nominal_.motors[i].rad_per_count), 0.0});
    }
    return frame;
  }
  void Obey(const std::vector<MotorCommand>& commands, std::size_t stuck = 99) {
    for (std::size_t i = 0; i < rad_.size(); ++i) {
      if (commands[i].mode != MotorMode::kPosition || i == stuck) continue;
      const double step = commands[i].speed_limit_rad_s * kControlPeriod * kTickSeconds;
      rad_[i] += std::clamp(commands[i].target - rad_[i], -step, step);
    }
    tick_ += kControlPeriod;
  }
  double rad(std::size_t motor) const { return rad_[motor]; }

 private:
  Nominal nominal_;
  std::vector<double> rad_;
  Tick tick_ = 0;
};

double DriveAll(ArcDrive& drive, IdealDrives& drives, std::size_t stuck = 99) {
  double time_s = 0.0;
  while (!drive.done() && time_s < 200.0) {
    drives.Obey(drive.Step(drives.Read()), stuck);
    time_s += kControlPeriod * kTickSeconds;
  }
  return time_s;
}

TEST(ArcDrive, TurnsEveryWheelByItsWayAndCountsTheWholeArc) {
  const Nominal nominal = NominalRover();
  ArcDrive drive(nominal);
  IdealDrives drives(nominal);
  std::vector<double> before(8, 0.0);
  for (const Arc& arc : {Arc{0.5, 0.4}, Arc{-0.3, 0.2}, Arc{0.2, 0.0}}) {
    drive.Start(arc);
    EXPECT_LT(DriveAll(drive, drives), 60.0);
    for (std::size_t i = 0; i < 6; ++i) {
      const double way_m = (drives.rad(i) - before[i]) * nominal.rolling_radius_m;
      EXPECT_NEAR(way_m, OnArc(nominal.plan.wheels[i], arc).way_m, 3e-4);
      before[i] = drives.rad(i);
    }
    EXPECT_NEAR(drives.rad(6), OnArc(nominal.plan.wheels[0], arc).steer_rad, Radians(0.2));
    const Pose2 whole = Advance({}, arc);
    EXPECT_NEAR(drive.moved().x, whole.x, 5e-4);
    EXPECT_NEAR(drive.moved().y, whole.y, 5e-4);
    EXPECT_NEAR(drive.moved().heading, whole.heading, 1e-3);
  }
}

TEST(ArcDrive, SteersWhileTheWheelsRest) {
  const Nominal nominal = NominalRover();
  ArcDrive drive(nominal);
  IdealDrives drives(nominal);
  drive.Start({0.5, 0.5});
  bool drove = false;
  while (!drive.done()) {
    const std::vector<MotorCommand> commands = drive.Step(drives.Read());
    const bool drives_now = commands[0].mode == MotorMode::kPosition;
    if (drives_now && !drove) {
      for (const std::size_t i : {6u, 7u}) {
        EXPECT_NEAR(drives.rad(i), OnArc(nominal.plan.wheels[i - 6], {0.5, 0.5}).steer_rad,
                    Radians(0.2));
      }
    }
    drove = drove || drives_now;
    drives.Obey(commands);
  }
  EXPECT_TRUE(drove);
}

TEST(ArcDrive, LeavesAWheelThatIsStuckAndCountsWhatTheOthersTurned) {
  const Nominal nominal = NominalRover();
  ArcDrive drive(nominal);
  IdealDrives drives(nominal);
  drive.Start({0.4, 0.0});
  EXPECT_LT(DriveAll(drive, drives, 2), 30.0);
  EXPECT_TRUE(drive.done());
  EXPECT_NEAR(drive.moved().x, 0.3, 1e-3);  // three of the four fixed wheels
}

TEST(ArcDrive, StopsHalfWayAndCountsWhatItDrove) {
  const Nominal nominal = NominalRover();
  ArcDrive drive(nominal);
  IdealDrives drives(nominal);
  drive.Start({0.5, 0.0});
  while (drive.share() < 0.5) drives.Obey(drive.Step(drives.Read()));
  drive.Stop(drives.Read());
  EXPECT_FALSE(drive.done());
  EXPECT_LT(DriveAll(drive, drives), 1.0);
  EXPECT_NEAR(drive.driven_m(), 0.25, 0.006);
  EXPECT_NEAR(drives.rad(0) * nominal.rolling_radius_m, drive.driven_m(), 1e-3);
}

}  // namespace
}  // namespace dockyard::rocky7
