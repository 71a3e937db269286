// The laws that turn and drive the robot by odometry in state 2 (F, D: "the inverse controller
// technique", "saturated and scaled", in two dimensions).
#pragma once

#include "controller/geometry/pose.h"
#include "controller/motion/path_follower.h"
#include "controller/raposa/align_plan.h"
#include "controller/raposa/nominal/ferreira_options.h"

namespace dockyard::raposa {

/// A turn in place at turn_rad_s that slows down over its last part.
Twist TurnBy(double left_rad, const FerreiraMotion& options);
bool Turned(double left_rad, const FerreiraMotion& options);

/// Towards the plan's end, from the robot's pose in O. A point lead_m ahead of the robot (behind
/// it, on a way backwards) is to come to the same point of the end, turned into the way: the
/// unicycle's inverse gives speed and turning rate, which corrects the heading on the way. Both are
/// scaled by one factor into the limits, so the curvature stays.
Twist DriveTo(const AlignPlan& plan, const Pose2& X_ON, const FerreiraMotion& options);
/// Of the way, along it [m]; below the tolerance, or beyond the end, the robot has arrived.
double WayLeft(const AlignPlan& plan, const Pose2& X_ON);
bool Arrived(const AlignPlan& plan, const Pose2& X_ON, const FerreiraMotion& options);

}  // namespace dockyard::raposa
