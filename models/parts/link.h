// A rigid link as URDF describes it: mass, visuals, collision shapes.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "controller/geometry/pose.h"
#include "models/parts/mesh.h"

namespace dockyard {

/// Collision geometry of a link, from its URDF <collision> elements.
struct BoxShape {
  Eigen::Vector3d size_m{0, 0, 0};
};
struct CylinderShape {
  double radius_m = 0.0, length_m = 0.0;  // along the shape frame's z
};
struct SphereShape {
  double radius_m = 0.0;
};
/// A convex solid turned about the shape frame's z axis: (z, radius) from the lowest z up.
struct TurnedShape {
  std::vector<Eigen::Vector2d> profile_m;
};
struct HullShape {
  std::vector<Eigen::Vector3d> points;  // convex hull of these, in the shape frame [m]
};
struct Collision {
  std::string name;
  std::variant<BoxShape, CylinderShape, SphereShape, HullShape, TurnedShape> shape;
  Pose3 X_LG;  // shape frame in the link frame
};

/// A rigid link as URDF describes it.
struct LinkModel {
  std::string name;
  double mass_kg = 0.0;
  Eigen::Vector3d p_LoCom_L = Eigen::Vector3d::Zero();  // centre of mass [m]
  Eigen::Matrix3d I_LCom_L = Eigen::Matrix3d::Zero();   // about the centre of mass [kg m^2]
  std::vector<Visual> visuals;
  std::vector<Collision> collisions;
};

}  // namespace dockyard
