// Commands to RAPOSA's motors. KeepLimits (controller/motion/limits.h) brings their speeds within
// the limits.
#pragma once

#include "controller/motion/path_follower.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// The belts for a twist in N (odometry.h).
void SetBelts(const Nominal& nominal, const Twist& twist_N, Commands* commands);
/// The arm to that angle against the body, tip down [rad since power-on].
void SetArm(const Nominal& nominal, double angle_rad, Commands* commands);
/// Both doors to closed, in that time.
void CloseDoors(const Nominal& nominal, double seconds, Commands* commands);

/// Both doors that far from closed, as fast as they go.
void SetDoors(const Nominal& nominal, double opening_m, Commands* commands);

}  // namespace dockyard::raposa
