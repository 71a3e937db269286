#include "sim/axel/cone_shapes.h"

#include <algorithm>
#include <cmath>

#include "models/parts/collision_reach.h"
#include "sim/physics/collision_shapes.h"

namespace dockyard::axel {
namespace {

// How far a wedge reaches under its neighbour; more than the deepest elastic penetration
// (300 N at 2e5 N/m: 1.5 mm).
constexpr double kWedgeOverlap_m = 4e-3;

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> ConeWedges(const ConeModel& cone) {
  const double half_angle = kPi / cone.wedges;
  // The facets' middles lie nearer the axis than their seams; the mean is the model's radius.
  const double to_facet = 2.0 * std::cos(half_angle) / (1.0 + std::cos(half_angle));
  const double mouth = cone.mouth_radius_m * to_facet, throat = cone.throat_radius_m * to_facet;
  const double slope = (mouth - throat) / cone.funnel_length_m;
  const double m = kCollisionMargin_m;
  const double lift = m * std::sqrt(1.0 + slope * slope);  // funnel's offset across the axis
  // Cut through a facet's middle: (x, distance from the axis), shrunk by the margin.
  const double corner = -cone.funnel_length_m + (m - lift) / slope;
  const std::vector<Eigen::Vector2d> cut = {
      {-m, mouth - slope * m + lift},       {corner, throat + m},
      {-cone.socket_end_m + m, throat + m}, {-cone.socket_end_m + m, cone.face_outer_radius_m - m},
      {-m, cone.face_outer_radius_m - m},
  };
  std::vector<std::vector<Eigen::Vector3d>> wedges;
  for (int k = 0; k < cone.wedges; ++k) {
    // Symmetric about the vertical plane through the axis.
    const double azimuth = (2 * k + 1) * half_angle;
    const Eigen::Vector3d out(0.0, std::sin(azimuth), std::cos(azimuth));
    const Eigen::Vector3d side(0.0, std::cos(azimuth), -std::sin(azimuth));
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector2d& c : cut) {
      const double width = c.y() * std::tan(half_angle) + kWedgeOverlap_m - m;
      const Eigen::Vector3d middle = c.x() * Eigen::Vector3d::UnitX() + c.y() * out;
      corners.push_back(middle - width * side);
      corners.push_back(middle + width * side);
    }
    wedges.push_back(corners);
  }
  return wedges;
}

Collision SocketStop(const ConeModel& cone) {
  constexpr double kThickness = 0.03;  // only its front is ever met
  const double side = 2.0 * cone.throat_radius_m + 2.0 * kWedgeOverlap_m;
  return {"stop", BoxShape{{kThickness, side, side}},
          Pose3::Translation(-cone.stop_depth_m - 0.5 * kThickness, 0.0, 0.0)};
}

std::vector<Collision> ArmCollisions(const RoverModel& rover) {
  const double tip_middle = rover.arm_length_m - 0.5 * rover.tip.length_m;
  const CollarModel& collar = rover.collar;
  const bool has_collar = collar.radius_m > 0.0;
  std::vector<Collision> collisions;
  for (const Collision& collision : rover.arm.collisions) {
    if (has_collar && collision.name == "collar") continue;
    if (ReachAlongX(collision) <= tip_middle) collisions.push_back(collision);
  }
  if (has_collar) {
    const double shoulder = collar.front_m - collar.lead_in_m;
    collisions.push_back({"collar",
                          TurnedShape{{{shoulder - collar.length_m, collar.radius_m},
                                       {shoulder, collar.radius_m},
                                       {collar.front_m, collar.front_radius_m}}},
                          Pose3{RotY(0.5 * kPi), Eigen::Vector3d::Zero()}});
  }
  Pose3 X_AG;
  X_AG.R = RotY(0.5 * kPi);
  X_AG.p.x() = tip_middle;
  collisions.push_back({"tip", CylinderShape{rover.tip.radius_m, rover.tip.length_m}, X_AG});
  return collisions;
}

}  // namespace dockyard::axel
