// Not a test: prints what the socket lets in. The robot drives straight onto the guide at 0.09 m/s,
// stops so far before its seat, and closes its doors; all else is as told.
#include <cmath>
#include <cstdio>
#include <vector>

#include "raposa/sim/raposa_rig.h"

namespace dockyard::raposa {
namespace {

constexpr double kSpeed_m_s = 0.09, kWay_m = 0.12;

struct Outcome {
  bool held = false;
  double shift_m = 0.0;   // of the pyramid, when the doors begin to close
  double before_m = 0.0;  // of the guide before its seat, then
};

Outcome Dock(const Pose2& X_DR_seat, double high_m, double arm_rad, double short_m, double aside_m,
             double turned_rad) {
  WorldSetup setup = AtStart(0.5);
  setup.pyramid.guide.height_m += high_m;
  // Where the robot stands kWay_m before that place.
  const Pose2 X_DR{X_DR_seat.x + short_m + kWay_m * std::cos(turned_rad),
                   aside_m + kWay_m * std::sin(turned_rad), turned_rad};
  const Eigen::Vector3d& p_RC = setup.robot.camera.X_RC.p;
  setup.X_DV_start = X_DR * Pose2{p_RC.x(), p_RC.y(), kPi};
  World world(setup);
  MotorCommands commands{};
  commands[2] = GoTo(setup, Motor::kArm, arm_rad);
  Play(world, setup, commands, 3.0);
  MotorCommands in = Belts(setup, -kSpeed_m_s, -kSpeed_m_s);
  in[2] = commands[2];
  Outcome outcome;
  for (int i = 0; i < 4000; ++i) {
    if (world.truth().X_WR.p.x() - setup.X_GD.x <= X_DR_seat.x + short_m) break;
    world.Step(in);
  }
  Play(world, setup, commands, 0.3);
  outcome.shift_m = world.truth().pyramid_shift_m;
  outcome.before_m = world.truth().p_SP_R.x();
  const double closed_rad = setup.robot.doors.travel_m / setup.robot.doors.pinion_radius_m;
  commands[3] = GoTo(setup, Motor::kLeftDoor, closed_rad);
  commands[4] = GoTo(setup, Motor::kRightDoor, closed_rad);
  Play(world, setup, commands, 6.5);
  outcome.held = world.truth().p_SP_R.norm() < 3e-3;
  return outcome;
}

// Where the robot's origin stands with the guide in its seat, as the arm leans the body.
double SeatOf(const RobotModel& robot, double arm_rad) {
  const BeltsModel& belts = robot.belts;
  const double lean =
      std::atan2(belts.arm_length_m * std::sin(arm_rad),
                 belts.body_front_m - belts.body_rear_m + belts.arm_length_m * std::cos(arm_rad));
  return -(robot.socket.p_RS.x() * std::cos(lean) - robot.socket.p_RS.z() * std::sin(lean));
}

void Print(const Outcome& o) {
  std::printf("  %s %4.1f %5.1f", o.held ? "+" : "-", 1e3 * o.shift_m, 1e3 * o.before_m);
}

}  // namespace
}  // namespace dockyard::raposa

// Held or not; how far the pyramid was pushed; how far the guide was in its seat [mm].
int main() {
  using namespace dockyard;
  using namespace dockyard::raposa;
  const RobotModel robot = AtStart(0.5).robot;
  const std::vector<double> shorts_m{-0.004, 0.002, 0.005, 0.008, 0.011};
  const auto heading = [&](const char* what) {
    std::printf("%s", what);
    for (const double s : shorts_m) std::printf("   %2.0f mm short ", 1e3 * s);
    std::printf("\n");
  };
  for (const double arm_deg : {6.0, 8.0, 10.0, 12.0, 14.0, 18.0}) {
    std::printf("arm %.0f deg\n", arm_deg);
    heading(" high mm");
    for (int high = -14; high <= 7; high += high < -6 ? 2 : 1) {
      std::printf(" %7d", high);
      for (const double s : shorts_m) {
        Print(Dock({SeatOf(robot, Radians(arm_deg)), 0.0, 0.0}, 1e-3 * high, Radians(arm_deg), s,
                   0.0, 0.0));
      }
      std::printf("\n");
    }
  }
  const double arm = Radians(10.0);
  for (const double turned_deg : {0.0, 3.0, 6.0, 9.0}) {
    std::printf("turned by %.0f deg, arm 10 deg\n", turned_deg);
    heading("aside mm");
    for (int aside = -15; aside <= 15; aside += 3) {
      std::printf(" %7d", aside);
      for (const double s : shorts_m) {
        Print(Dock({SeatOf(robot, arm), 0.0, 0.0}, 0.0, arm, s, 1e-3 * aside, Radians(turned_deg)));
      }
      std::printf("\n");
    }
  }
  return 0;
}
