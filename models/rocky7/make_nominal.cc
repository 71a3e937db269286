#include "models/rocky7/make_nominal.h"

namespace dockyard::rocky7 {

Nominal MakeNominal(const RobotModel& robot) {
  Nominal nominal;
  nominal.plan = robot.rover.plan;
  nominal.motors.assign(robot.rover.plan.wheels.size(), NominalOf(robot.rover.drive));
  for (const WheelPlan& wheel : robot.rover.plan.wheels) {
    if (wheel.steer_limit_rad > 0.0) nominal.motors.push_back(NominalOf(robot.rover.steer));
  }
  nominal.rolling_radius_m = RollingRadius(robot.rover.tyre);
  nominal.front = robot.front.nominal;
  return nominal;
}

}  // namespace dockyard::rocky7
