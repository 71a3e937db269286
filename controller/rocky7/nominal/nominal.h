// Rocky 7's nominal parameters: what calibration, drawings and the user's click tell its
// controllers. The world is built from its own numbers, which differ.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/rover_plan.h"
#include "controller/io/nominal_motor.h"
#include "controller/rocky7/nominal/motors.h"

namespace dockyard::rocky7 {

/// What Nesnas, Maimone and Das (ICRA 2000) leave open of their tracking loop; "N" is that paper.
struct NesnasTracking {
  double window_m = 0.06;      // half of the search window's side; assumed, 0.03-0.12: "small"
  double image_share = 0.1;    // of the trajectory, then the rover stops and looks (N, IV)
  double least_step_m = 0.03;  // shorter ones are driven at once; assumed, 0.01-0.05

  bool operator==(const NesnasTracking&) const = default;
};

/// What the rover is asked for.
enum class Task { kReach, kGrasp };

/// The arm as its drawing has it. Angles as ArmMotor has them; at 0 the arm points ahead and level.
struct NominalArm {
  Eigen::Vector3d p_RA{0, 0, 0};  // shoulder
  double length_m = 0.0;          // from the shoulder to the scoops' axis
  double scoop_depth_m = 0.0;     // from the axis to the lips
  double open_rad = 0.0;          // back scoop's angle less the front one's, at most

  bool operator==(const NominalArm&) const = default;
};

/// R: the rover's body. Its origin lies between the tandem wheels, at the height of their axles; x
/// forward, y left, z up.
struct Nominal {
  RoverPlan plan;
  std::vector<NominalMotor> motors;
  double rolling_radius_m = 0.0;  // of every wheel; R stands so high above level ground
  StereoRig front;
  NominalArm arm;
  Task task = Task::kReach;
  double reach_m = 0.01;            // how near the point P must come to the target (N, V)
  Eigen::Vector2d target_px{0, 0};  // the user's click in the first picture of the left camera
  NesnasTracking nesnas{};
};

/// The point on level ground, in R's plan, below the scoops' axis where they close.
inline Eigen::Vector2d GraspPoint(const NominalArm& arm, double rolling_radius_m) {
  // Of the axis over the ground. Assumed, 30-50 mm: it rises by some centimetres as they close.
  constexpr double kAxis_m = 0.04;
  const double down_m = arm.p_RA.z() + rolling_radius_m - kAxis_m;
  const double ahead_m = std::sqrt(arm.length_m * arm.length_m - down_m * down_m);
  return {arm.p_RA.x() + ahead_m, arm.p_RA.y()};
}

}  // namespace dockyard::rocky7
