// The drive of a robot: differential, with driven wheels at two sides that keep their direction.
//
// Frame A: the middle of the driven wheels, on the ground; axes as R. The robot turns about it.
#pragma once

#include <vector>

#include "controller/base/result.h"
#include "controller/custom/nominal/nominal.h"
#include "controller/custom/refusal.h"
#include "controller/io/commands.h"
#include "controller/motion/path_follower.h"

namespace dockyard::custom {

struct DrivenWheel {
  int motor = -1;
  double side = 0.0;              // left 1, right -1
  double travel_m_per_rad = 0.0;  // of the rim, forward, for a radian of the motor's output; signed
};

struct Drive {
  std::vector<DrivenWheel> wheels;
  Pose2 X_RA;
  double gauge_m = 0.0;  // between the sides, from the wheels' places
  // The robot's turns over those that the gauge gives. Two wheels: 1. More scrub sideways.
  double turn_share = 1.0;
};

/// Two driven wheels, or four or six that a skid-steered robot drives alike on a side. Refuses
/// steered wheels, axles that do not point along y, and fixed wheels off the axle that are not
/// driven.
Result<Drive, Refusal> FindDrive(const Nominal& nominal);

/// The largest share of a twist of A, at most 1, that all motors can run; it keeps the curvature.
double ShareWithinMotors(const Drive& drive, const Nominal& nominal, const Twist& twist);

/// Runs the wheels at a twist of A; every other motor is braked.
Commands RunAt(const Drive& drive, const Nominal& nominal, const Twist& twist);

/// Speed of a wheel's motor at its output [rad/s].
double MotorSpeed(const Drive& drive, const DrivenWheel& wheel, const Twist& twist);

}  // namespace dockyard::custom
