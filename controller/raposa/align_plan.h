// The manoeuvre of region II (F, C.2 and Fig. 3): turn, travel, turn, to a place on the pyramid's
// axis from where the robot faces it.
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard::raposa {

/// What the marks say of the pyramid's place.
struct GuidePlace {
  double r_m = 0.0;          // from the camera to the guide, in plan
  double alpha_rad = 0.0;    // of the camera about the guide, counter-clockwise from its axis
  double bearing_rad = 0.0;  // of the guide, to the right of the camera's axis
};

/// In O: N (odometry.h) where the plan was made.
struct AlignPlan {
  double beta_rad = 0.0;  // first turn, to the left; less than a quarter turn
  double way_m = 0.0;     // then this far; < 0: backwards, where the place lies behind
  double phi_rad = 0.0;   // last turn
  Pose2 X_OE;             // the end: x_ref, y_ref of Fig. 3, and the heading
};

/// The camera ends standoff_m before the guide on its axis, looking at it. The robot turns about a
/// point that lies lever_m ahead of the camera (towards the arm); with no lever it is the paper's
/// figure: D^2 = r^2 + delta^2 - 2 r delta cos alpha, sin beta = delta sin alpha / D. The paper
/// tells of no lever: whoever aligned the real robot had to know it. Where beta passes a quarter
/// turn the robot turns the other way and reverses ("the robot has to move backwards", F, F).
AlignPlan PlanAlignment(const GuidePlace& guide, double standoff_m, double lever_m);

/// The guide's place in N.
Eigen::Vector2d GuideInN(const GuidePlace& guide, double lever_m);
/// The robot's pose in P: the guide's middle, x out along its axis.
Pose2 PoseOfN(const GuidePlace& guide, double lever_m);

/// The turn of the robot that moves a guide from straight ahead to that bearing (right is positive,
/// as a turn to the left has it), for a guide at range_m from the turning centre: from a camera
/// behind that centre it moves further than the robot turns.
double TurnOfBearing(double bearing_rad, double range_m, double lever_m);

}  // namespace dockyard::raposa
