#include "models/rocky7/make_nominal.h"

namespace dockyard::rocky7 {
namespace {

/// Suspension and brackets are taken to be at their hinges and over their wheels, at the axles.
NominalMasses MassesOf(const RoverModel& rover) {
  NominalMasses masses;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  const auto add = [&](double kg, const Eigen::Vector3d& p_R) {
    masses.rover_kg += kg;
    moment += kg * p_R;
  };
  add(rover.body.mass_kg, rover.body.p_LoCom_L);
  for (const WheelPlan& wheel : rover.plan.wheels) {
    const double bracket_kg = wheel.steer_limit_rad > 0.0 ? rover.bracket_kg : 0.0;
    add(rover.wheel_kg + bracket_kg, {wheel.p_RW.x(), wheel.p_RW.y(), 0.0});
  }
  const SuspensionModel& hinges = rover.suspension;
  if (hinges.kind == SuspensionKind::kRockerBogie) {
    add(2.0 * hinges.rocker_kg, {hinges.pivot_x_m, 0.0, hinges.pivot_z_m});
    add(2.0 * hinges.bogie_kg, {hinges.bogie_x_m, 0.0, hinges.bogie_z_m});
  }
  const MastModel& mast = *rover.mast;
  add(mast.housing_kg, mast.p_RM);
  masses.p_RC = moment / masses.rover_kg;
  const ArmModel& arm = *rover.arm;
  masses.arm_kg = arm.mass_kg + 2.0 * arm.scoop.mass_kg;
  masses.arm_middle_m =
      arm.length_m * (0.5 * arm.mass_kg + 2.0 * arm.scoop.mass_kg) / masses.arm_kg;
  masses.link1_kg = mast.link1_kg;
  masses.link2_kg = mast.link2_kg + mast.instrument.mass_kg;
  masses.link2_middle_m =
      (0.5 * mast.link2_kg * mast.link2_m +
       mast.instrument.mass_kg * (mast.link2_m - 0.5 * mast.instrument.length_m)) /
      masses.link2_kg;
  return masses;
}

}  // namespace

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
  nominal.masses = MassesOf(robot.rover);
  nominal.rolling_radius_m = RollingRadius(robot.rover.tyre);
  nominal.front = robot.front.nominal;
  nominal.back = robot.back.nominal;
  return nominal;
}

}  // namespace dockyard::rocky7
