// A camera behind a round hole, and what the hole leaves of its view.
#pragma once

#include <Eigen/Core>

namespace dockyard {

/// A round hole in a plane across the camera's axis; its rim is dark.
struct ViewHole {
  double half_angle_rad = 0.0;       // of the hole seen from the pupil; 0: no hole
  double distance_m = 0.05;          // pupil to hole; assumed, 0.03-0.10
  double pupil_m = 0.0015;           // its diameter; assumed, 4 mm lens at f/2.8, 1-2 mm
  Eigen::Vector2d middle{0.0, 0.0};  // the hole's, x / z and y / z in the camera frame

  bool operator==(const ViewHole&) const = default;
};

/// Share of the pupil that sees out through the hole along (tan, 1), far away: two discs' overlap.
double ShareThroughHole(const ViewHole& hole, const Eigen::Vector2d& tan);

/// Checks that the numbers are a hole's.
void CheckHole(const ViewHole& hole);

}  // namespace dockyard
