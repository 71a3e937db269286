// A robot and a dock for the tests: two wheels and a caster, a camera ahead, a board over the
// contact.
#pragma once

#include "controller/custom/nominal/nominal.h"

namespace dockyard::custom {

struct TestRobot {
  double left_travel_per_rad = 1.0, right_travel_per_rad = 1.0;
  double left_axle = 1.0, right_axle = 1.0;  // direction along y
  double axle_x_m = 0.0;                     // of the driven wheels in R
  double gauge_m = 0.4, radius_m = 0.08;
  bool docks_backward = false;
  bool rear_camera = false;  // in place of the camera ahead
  bool contact = true;
};

Nominal NominalOf(const TestRobot& robot = {});

/// X_RC of a camera on level ground whose view turns by that yaw from x of R.
Pose3 CameraAt(const Eigen::Vector3d& p_RC, double yaw_rad);

/// The other pose of a plane that explains its image nearly alike: mirrored along the line of
/// sight, and a rotation again.
Pose3 Mirrored(const Pose3& X_CB);

/// A turn about the vector by its length.
Eigen::Matrix3d TurnAbout(const Eigen::Vector3d& turn_rad);

}  // namespace dockyard::custom
