// Parts of short URDF files.
#pragma once

#include <Eigen/Core>
#include <string>

#include "controller/base/number_text.h"

namespace dockyard {

/// A link's mass as that of a solid box about its own origin.
inline std::string InertialOfBox(double mass_kg, const Eigen::Vector3d& size) {
  const Eigen::Vector3d s = size.cwiseProduct(size);
  return "<inertial><mass value=\"" + NumberText(mass_kg) + "\"/><inertia ixx=\"" +
         NumberText(mass_kg * (s.y() + s.z()) / 12) + "\" iyy=\"" +
         NumberText(mass_kg * (s.x() + s.z()) / 12) + "\" izz=\"" +
         NumberText(mass_kg * (s.x() + s.y()) / 12) +
         "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
}

inline std::string BoxGeometry(const Eigen::Vector3d& size) {
  return "<geometry><box size=\"" + NumberText(size.x()) + " " + NumberText(size.y()) + " " +
         NumberText(size.z()) + "\"/></geometry>";
}

}  // namespace dockyard
