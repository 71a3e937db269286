// Where a spectator stands.
#pragma once

#include <optional>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/pose.h"

namespace dockyard {

/// A pinhole whose image is `vertical_fov_rad` high.
Camera PinholeCamera(int width, int height, double vertical_fov_rad);

/// The camera's pose at `from_W` with `centre_W` in the middle of its image and the world's z
/// upwards in it. A line between them that
/// is upright has the world's x to the right.
Pose3 PoseAimedAt(const Eigen::Vector3d& from_W, const Eigen::Vector3d& centre_W);

/// What a spectator wants to see.
struct Sights {
  std::vector<Eigen::Vector3d> places_W;   // the robot's way and the target; at least one
  double margin_m = 0.6;                   // what lies round each of them
  std::vector<Eigen::Vector3d> corners_W;  // of what is to be whole in the image, without a margin
  Pose2 X_WD;                              // the target's frame, its x out of its face
  Eigen::Vector3d to_sun_W{0, 0, 1};
};

/// The unit vector with that azimuth and height over a plane.
Eigen::Vector3d Direction(double azimuth_rad, double height_rad);

/// From the target to a spectator from whom neither robot nor target hides the other: aside of the
/// target's axis, which has that heading, on the side of the sun, and above.
Eigen::Vector3d UsualDirection(double heading_rad, const Eigen::Vector3d& to_sun_W);

/// A camera in the usual direction, as near as all places are in its image. With `from_D`, it is
/// there (in the target's frame, z from its ground).
Pose3 SpectatorPose(const Sights& sights, const Camera& camera,
                    const std::optional<Eigen::Vector3d>& from_D);

}  // namespace dockyard
