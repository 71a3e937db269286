#include "models/rocky7/make_nominal.h"

namespace dockyard::rocky7 {

Nominal MakeNominal(const RobotModel& robot) {
  Nominal nominal;
  nominal.plan = robot.rover.plan;
  nominal.motors.assign(robot.rover.plan.wheels.size(), NominalOf(robot.rover.drive));
  for (const WheelPlan& wheel : robot.rover.plan.wheels) {
    if (wheel.steer_limit_rad > 0.0) nominal.motors.push_back(NominalOf(robot.rover.steer));
  }
  const ArmModel& arm = *robot.rover.arm;
  for (const MotorModel* motor : {&arm.roll, &arm.pitch, &arm.scoop_motor, &arm.scoop_motor}) {
    nominal.motors.push_back(NominalOf(*motor));
  }
  nominal.arm = {.p_RA = arm.p_RA,
                 .length_m = arm.length_m,
                 .scoop_depth_m = arm.scoop.depth_m,
                 .open_rad = MostOpen_rad(arm.scoop)};
  nominal.rolling_radius_m = RollingRadius(robot.rover.tyre);
  nominal.front = robot.front.nominal;
  return nominal;
}

}  // namespace dockyard::rocky7
