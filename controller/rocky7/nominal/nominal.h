// Rocky 7's nominal parameters: what calibration, drawings and the user's click tell its
// controllers. The world is built from its own numbers, which differ.
#pragma once

#include <Eigen/Core>
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

/// R: the rover's body. Its origin lies between the tandem wheels, at the height of their axles; x
/// forward, y left, z up.
struct Nominal {
  RoverPlan plan;
  std::vector<NominalMotor> motors;
  double rolling_radius_m = 0.0;  // of every wheel; R stands so high above level ground
  StereoRig front;
  double reach_m = 0.01;            // how near the point P must come to the target (N, V)
  Eigen::Vector2d target_px{0, 0};  // the user's click in the first picture of the left camera
  NesnasTracking nesnas{};
};

}  // namespace dockyard::rocky7
