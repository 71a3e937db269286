// Solids turned about the z axis: how far a point or a circle is from one.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

/// A solid turned about the z axis whose cut through the axis is convex. It may leave the axis
/// free: the wall of a funnel is such a solid.
class TurnedSolid {
 public:
  /// outline_m: corners (z, r) of the cut, the solid to the right of the way from one to the next.
  /// It is closed from the last corner to the first, except along the axis.
  /// Throws std::invalid_argument when the cut is not convex.
  explicit TurnedSolid(const std::vector<Eigen::Vector2d>& outline_m);

  struct Nearest {
    double distance_m = 0.0;           // < 0 inside
    Eigen::Vector2d normal{0.0, 0.0};  // (z, r), out of the solid; the distance's gradient
    bool on_side = true;               // not on a corner of the cut
  };
  /// Of the point (z, r), r >= 0. Inside, the nearest side counts.
  Nearest NearestTo(const Eigen::Vector2d& point_m) const;
  /// Whether one of the solid's sides shows that every point of this box of the cut (z, r) is at
  /// least so far away.
  bool IsBeyond(const Eigen::AlignedBox2d& cut_m, double distance_m) const;

 private:
  struct Side {
    Eigen::Vector2d from, along, out;
    double length_m = 0.0, offset_m = 0.0;
  };
  std::vector<Side> sides_;
};

/// A circle: centre + radius (x cos + y sin).
struct Ring {
  Eigen::Vector3d centre{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0};  // x, y: unit, at right angles
  double radius_m = 0.0;
};
Ring operator*(const Pose3& X, const Ring& ring);

/// A place where a ring is near a solid, in the solid's frame.
struct RingPoint {
  double angle_rad = 0.0;  // on the ring
  double distance_m = 0.0;
  Eigen::Vector3d p{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 0};  // out of the solid
  bool on_side = true;              // of the solid; false on an edge
  double share = 1.0;               // of the contact's stiffness: 1/3 where a ring lies flat
};

inline constexpr int kMostRingPoints = 4;
using RingPoints = std::array<RingPoint, kMostRingPoints>;

/// The ring's places of least distance that are nearer than within_m; on a flat end of the solid,
/// where a ring that lies on it is near all round, that place and those 120 deg from it; the share
/// of each goes from 1/3, level, to 1 where the ring is tilted by a millimetre. Returns their
/// count. The solid's axis is z of the frame that the ring is given in.
/// all_round: a ring that is near a solid's side all round, as in a cone that fits it, counts by
/// three places, or by four where two are least; the share of each goes from a third or a quarter,
/// equally near, to 1 where they differ by within_m. So what bears does not jump to the other side.
int FindNearPoints(const Ring& ring, const TurnedSolid& solid, double within_m, RingPoints& points,
                   bool all_round = false);

}  // namespace dockyard
