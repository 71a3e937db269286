// Commands to RAPOSA's motors. KeepLimits (controller/motion/limits.h) brings their speeds within
// the limits.
#pragma once

#include "controller/motion/path_follower.h"
#include "controller/raposa/dockyard_options.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// The belts for a twist in N (odometry.h).
void SetBelts(const Nominal& nominal, const Twist& twist_N, Commands* commands);
/// In place, in proportion to what is left, at most at this rate and not slower than belts run.
Twist TurnAt(double left_rad, double most_rad_s, const DockyardOptions& options);
/// Of the arm on the seat at this try, from 0. Each after the first has another: a guide that is
/// built higher or lower than nominal meets the seat at another lean.
double PressAngle(const DockyardOptions& options, int tries);
/// The arm to that angle against the body, tip down [rad since power-on].
void SetArm(const Nominal& nominal, double angle_rad, Commands* commands);
/// Both doors to closed, in that time.
void CloseDoors(const Nominal& nominal, double seconds, Commands* commands);

/// Both doors that far from closed, as fast as they go.
void SetDoors(const Nominal& nominal, double opening_m, Commands* commands);

}  // namespace dockyard::raposa
