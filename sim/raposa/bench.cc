#include "sim/raposa/bench.h"

#include <cmath>

namespace dockyard::raposa {

WorldSetup OnLevelGround(const RobotModel& robot, const PyramidModel& pyramid,
                         const GroundModel& ground, double r_m, double alpha_rad) {
  WorldSetup setup;
  setup.robot = robot;
  setup.robot.belts.speed_offset = 0.0;
  setup.pyramid = pyramid;
  setup.grounds = {ground};
  setup.ground = LevelGrid(-4.0, 10.0, 10.0, 0.1);
  setup.X_DV_start = FromDockingCoords({r_m, alpha_rad, alpha_rad});
  return setup;
}

MotorCommand Run(const WorldSetup& setup, Motor motor, double rad_s) {
  const MotorModel& model = setup.robot.motors[static_cast<std::size_t>(motor)];
  return {.mode = MotorMode::kVelocity,
          .target = rad_s,
          .accel_rad_s2 = model.max_accel_rad_s2,
          .current_limit_a = model.max_current_a};
}

MotorCommand GoTo(const WorldSetup& setup, Motor motor, double rad) {
  const MotorModel& model = setup.robot.motors[static_cast<std::size_t>(motor)];
  return {.mode = MotorMode::kPosition,
          .target = rad,
          .speed_limit_rad_s = model.max_speed_rad_s,
          .accel_rad_s2 = model.max_accel_rad_s2,
          .current_limit_a = model.max_current_a};
}

MotorCommands Belts(const WorldSetup& setup, double left_m_s, double right_m_s) {
  const double radius_m = setup.robot.belts.roller_radius_m;
  MotorCommands commands{};
  commands[0] = Run(setup, Motor::kLeftBelt, left_m_s / radius_m);
  commands[1] = Run(setup, Motor::kRightBelt, right_m_s / radius_m);
  return commands;
}

void Play(World& world, const WorldSetup& setup, const MotorCommands& commands, double seconds) {
  const long steps = std::lround(seconds / setup.step_s);
  for (long i = 0; i < steps; ++i) world.Step(commands);
}

}  // namespace dockyard::raposa
