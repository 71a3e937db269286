// RAPOSA's world at a start, and commands for it.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "sim/raposa/world.h"
#include "support/source_tree.h"

namespace dockyard::raposa {

using MotorCommands = std::array<MotorCommand, kMotorCount>;

/// On the hard floor, r from the camera to the guide, the camera looking at it. Belts without
/// errors of their readings.
inline WorldSetup AtStart(double r_m, double alpha_rad = 0.0) {
  const std::string models = SourceFile("models/raposa/");
  WorldSetup setup;
  setup.robot = LoadRobot(models + "raposa.yaml");
  setup.pyramid = LoadPyramid(models + "pyramid/pyramid.yaml");
  setup.robot.belts.speed_offset = 0.0;
  setup.grounds[0].belt = kHardFloor;
  setup.ground = LevelGrid(-4.0, 10.0, 10.0, 0.1);
  setup.X_DV_start = FromDockingCoords({r_m, alpha_rad, alpha_rad});
  return setup;
}

inline MotorCommand Run(const WorldSetup& setup, Motor motor, double rad_s) {
  const MotorModel& model = setup.robot.motors[static_cast<std::size_t>(motor)];
  return {.mode = MotorMode::kVelocity,
          .target = rad_s,
          .accel_rad_s2 = model.max_accel_rad_s2,
          .current_limit_a = model.max_current_a};
}

inline MotorCommand GoTo(const WorldSetup& setup, Motor motor, double rad) {
  const MotorModel& model = setup.robot.motors[static_cast<std::size_t>(motor)];
  return {.mode = MotorMode::kPosition,
          .target = rad,
          .speed_limit_rad_s = model.max_speed_rad_s,
          .accel_rad_s2 = model.max_accel_rad_s2,
          .current_limit_a = model.max_current_a};
}

/// Belts at these speeds of their surfaces, all else braked.
inline MotorCommands Belts(const WorldSetup& setup, double left_m_s, double right_m_s) {
  const double radius_m = setup.robot.belts.roller_radius_m;
  MotorCommands commands{};
  commands[0] = Run(setup, Motor::kLeftBelt, left_m_s / radius_m);
  commands[1] = Run(setup, Motor::kRightBelt, right_m_s / radius_m);
  return commands;
}

inline void Play(World& world, const WorldSetup& setup, const MotorCommands& commands,
                 double seconds) {
  const long steps = std::lround(seconds / setup.step_s);
  for (long i = 0; i < steps; ++i) world.Step(commands);
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
