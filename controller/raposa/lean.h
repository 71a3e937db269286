// How the body leans back when the arm is pressed down, on hard and level ground.
#pragma once

#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// Front up positive [rad]. The robot stands on its rear rollers and the arm's tip rollers, all of
/// one size: L sin b = a sin(arm - b), L between the body's rollers, a of the arm. None for an arm
/// that is level or raised.
double LeanOf(const Nominal& nominal, double arm_rad);

/// The seat's way behind the robot's origin, in plan, at that lean.
double SeatBehind(const Nominal& nominal, double lean_rad);

/// The camera in plan, V in N (pyramid_filter.h), and below the level [rad, down positive], on
/// level ground with the body level: as it is told to be mounted.
Pose2 CameraInPlan(const Nominal& nominal);
double CameraPitch(const Nominal& nominal);

}  // namespace dockyard::raposa
