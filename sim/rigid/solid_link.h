// A link of a tree made of a solid.
#pragma once

#include "sim/rigid/solid_mass.h"
#include "sim/rigid/tree_body.h"

namespace dockyard {

/// A solid on a hinge at p_PL of its parent, about an axis in the link's frame, which is the
/// solid's. `rotor_kg_m2`: of the motor, at the joint.
inline TreeLink SolidLink(int parent, const Eigen::Vector3d& p_PL, const Eigen::Vector3d& axis_L,
                          const SolidMass& solid, double rotor_kg_m2 = 0.0) {
  TreeLink link;
  link.model.mass_kg = solid.mass_kg;
  link.model.p_LoCom_L = solid.p_com;
  link.model.I_LCom_L = solid.I_com;
  link.parent = parent;
  link.p_PL = p_PL;
  link.axis_L = axis_L;
  link.rotor_kg_m2 = rotor_kg_m2;
  return link;
}

}  // namespace dockyard
