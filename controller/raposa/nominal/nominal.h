// RAPOSA's nominal parameters: the numbers from calibration and drawings that its controllers use.
// The world is built from its own numbers, which differ.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/io/nominal_motor.h"
#include "controller/raposa/nominal/ferreira_options.h"
#include "controller/raposa/nominal/motors.h"

namespace dockyard::raposa {

/// The marks on the pyramid. In the frame P of the guide's middle (x out along its axis towards the
/// robot that docks, y left, z up) the blue square stands upright at x = -behind_m, its middle at
/// the guide's height.
struct Marks {
  double edge_m = 0.0;            // of the blue square: h of eq. (2)
  double behind_m = 0.0;          // from the guide's middle to the square: m of eq. (5)
  double guide_diameter_m = 0.0;  // of the orange bi-cone, at its widest
  double guide_length_m = 0.0;
  double guide_height_m = 0.0;  // of its middle above the ground
  // Paint round the square's edges: from x = -behind_m forward on the pyramid's sides, and as wide
  // on the faces that rise from there towards the guide.
  double strip_m = 0.0, rise_rad = 0.0;
  double guide_half_angle_rad = 0.0;  // of its two cones
  double guide_up_rad = 0.0;          // of its axis above the level, towards the robot
  double rod_radius_m = 0.0;          // from the guide to the square
  double guide_blunt_radius_m = 0.0;  // where its front ends

  bool operator==(const Marks&) const = default;
};

/// A grey part of the pyramid, as a box along the axes of P.
struct GreyBox {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();

  bool operator==(const GreyBox&) const = default;
};

/// R: the robot's body, x towards the arm, y left, z up. The robot docks with its back, so a
/// pyramid ahead of the camera lies along -x.
struct Nominal {
  std::array<NominalMotor, kMotorCount> motors;  // by Motor
  Camera camera;
  Pose3 X_RC;
  double camera_delay_s = 0.0;  // from a picture's exposure to the time it is stamped with
  double half_view_rad = 0.0;   // what the hole leaves of the camera's view, from its axis
  Marks marks;
  std::vector<GreyBox> grey_boxes;  // behind and under the marks
  double sprocket_radius_m = 0.0;
  double gauge_m = 0.0;            // between the belts' middles
  double effective_gauge_m = 0.0;  // d of eq. (9), from one turn in place on a hard floor
  double body_belt_m = 0.0;        // between the body's rollers
  double arm_length_m = 0.0;       // from its joint, on the front roller, to the tip's roller
  double door_pinion_radius_m = 0.0;
  double door_travel_m = 0.0;                      // from open to closed on the guide's waist
  Eigen::Vector3d p_RS = Eigen::Vector3d::Zero();  // the guide's middle once docked
  FerreiraVision ferreira_vision{};                // of the controller of that name
  FerreiraMotion ferreira_motion{};
};

}  // namespace dockyard::raposa
