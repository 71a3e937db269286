// RAPOSA's world at a start, and commands for it.
#pragma once

#include <cmath>
#include <string>

#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "sim/raposa/bench.h"
#include "support/source_tree.h"

namespace dockyard::raposa {

/// On the hard floor, r from the camera to the guide, the camera looking at it. Belts without
/// errors of their readings.
inline WorldSetup AtStart(double r_m, double alpha_rad = 0.0) {
  const std::string models = SourceFile("models/raposa/");
  GroundModel ground;
  ground.belt = kHardFloor;
  return OnLevelGround(LoadRobot(models + "raposa.yaml"),
                       LoadPyramid(models + "pyramid/pyramid.yaml"), ground, r_m, alpha_rad);
}

inline double HeadingOf(const Truth& truth) {
  return std::atan2(truth.X_WR.R(1, 0), truth.X_WR.R(0, 0));
}

/// Drives straight in, presses the arm down on the way, and closes the doors.
inline void DockStraight(World& world, const WorldSetup& setup, double way_m, double arm_rad) {
  MotorCommands in = Belts(setup, -0.03, -0.03);
  in[2] = GoTo(setup, Motor::kArm, arm_rad);
  Play(world, setup, in, way_m / 0.03);
  MotorCommands close{};
  close[2] = in[2];
  const double closed_rad = setup.robot.doors.travel_m / setup.robot.doors.pinion_radius_m;
  close[3] = GoTo(setup, Motor::kLeftDoor, closed_rad);
  close[4] = GoTo(setup, Motor::kRightDoor, closed_rad);
  Play(world, setup, close, 6.5);
}

}  // namespace dockyard::raposa
