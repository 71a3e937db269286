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
  const MastModel& mast = *robot.rover.mast;
  for (const MotorModel& motor : mast.motors) nominal.motors.push_back(NominalOf(motor));
  nominal.mast = {.p_RM = mast.p_RM,
                  .link1_m = mast.link1_m,
                  .link2_m = mast.link2_m,
                  .low_rad = mast.low_rad,
                  .high_rad = mast.high_rad,
                  .stowed_rad = mast.stowed_rad,
                  .watch_rad = mast.watch_rad,
                  .switch_radius_m = mast.instrument.switch_radius_m,
                  .pair_K = robot.mast_pair.nominal};
  nominal.rolling_radius_m = RollingRadius(robot.rover.tyre);
  nominal.front = robot.front.nominal;
  nominal.back = robot.back.nominal;
  return nominal;
}

}  // namespace dockyard::rocky7
