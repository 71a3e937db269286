// Commands to RAPOSA's motors from what the controller wants of them.
#pragma once

#include "controller/motion/path_follower.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// The belts for a twist in N (odometry.h), within their speeds.
void SetBelts(const Nominal& nominal, const Twist& twist_N, Commands* commands);
/// The arm to that angle against the body, tip down [rad since power-on].
void SetArm(const Nominal& nominal, double angle_rad, Commands* commands);
/// Both doors to closed, in that time.
void CloseDoors(const Nominal& nominal, double seconds, Commands* commands);

}  // namespace dockyard::raposa
