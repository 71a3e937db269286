// Where a belt's pads meet the ground in one step.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "sim/rigid/motion.h"
#include "sim/vehicles/belt_loop.h"
#include "sim/vehicles/ground_plane.h"

namespace dockyard {

/// The carrying link and the ground under it in one step.
struct BeltPlace {
  GroundPlane ground;
  Eigen::Vector3d x_G, y_G, z_G;  // axes of the carrier
  Eigen::Vector3d p_G, middle_G;  // its origin, and the belt's middle plane's from there
  Eigen::Vector3d v_G, w_G;       // of the origin, and turning
  double down_rad = 0.0;          // direction in the plane of x and z that leads down
  double speed_m_s = 0.0, dt_s = 0.0;
  // Of the pad that was loaded last: the ground's normal, and forward and left in its plane.
  Eigen::Vector3d n_G = Eigen::Vector3d::Zero(), forward_G = n_G, left_G = n_G;

  BeltPlace(const HeightGrid& grid, const LinkMotion& carrier, double y_m);
  /// A belt that lies on its side has no forward.
  void Face(const Eigen::Vector3d& normal_G) {
    n_G = normal_G;
    forward_G = y_G.cross(n_G).normalized();
    left_G = n_G.cross(forward_G);
  }
};

/// The parts of one pad that touch, summed over its pieces on runs and rollers.
struct BeltTouch {
  double area_m2 = 0.0;                             // integral of the depth over the length
  double length_m = 0.0;                            // that touches
  Eigen::Vector3d arm_G = Eigen::Vector3d::Zero();  // from the carrier's origin, times area_m2
  Eigen::Vector3d up_G = Eigen::Vector3d::Zero();   // the ground's normal, times area_m2
  Eigen::Vector3d in_G = Eigen::Vector3d::Zero();   // the belt's inward normal, times area_m2
  double front_m = -std::numeric_limits<double>::infinity();  // in the carrier's x
  double rear_m = std::numeric_limits<double>::infinity();
};

/// The part of a segment that may touch, from begin_m to end_m of the loop; empty if begin_m is not
/// less. On a roller it is the part that is no higher than the ground at three places under it, and
/// this margin.
struct BeltWindow {
  double begin_m = 0.0, end_m = 0.0;
};
BeltWindow WindowOf(const BeltSegment& segment, const BeltPlace& at, double margin_m);

/// Adds the part of the loop from begin_m to end_m, all on one segment, that is below the ground.
/// The ground under it is taken as a plane, the arc of a roller as a parabola.
void AddPiece(const BeltSegment& segment, double begin_m, double end_m, const BeltPlace& at,
              BeltTouch& touch);

}  // namespace dockyard
