// One belt, and the whole robot turning in place, on a ground: no controller, no camera.
#pragma once

#include "sim/raposa/bench.h"
#include "sim/vehicles/belt_trial.h"

namespace dockyard::raposa {

/// A main belt alone.
BeltTrialResult TryBelt(const RobotModel& robot, const GroundModel& ground, const BeltTrial& trial);

struct TurningResult {
  double gauge_m = 0.0;    // effective: the belts' difference of speeds over the turning rate
  double centre_m = 0.0;   // x of the point in the body that stays
  double current_a = 0.0;  // of one belt's motor, mean of both
  double torque_nm = 0.0;  // of one sprocket, mean of both
  double turn_rad_s = 0.0;
};

/// @param base          of OnLevelGround
/// @param arm_rad       pressed down by this
/// @param belt_m_s      of each belt's surface, against each other
TurningResult TryTurning(const WorldSetup& base, double arm_rad, double belt_m_s);

}  // namespace dockyard::raposa
