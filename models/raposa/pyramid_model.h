// The pyramid at the tether's end, as built. Frame P: the guide's middle, x level and out along its
// axis towards the robot that docks, y left, z up.
#pragma once

#include <string>
#include <vector>

#include "models/parts/link.h"

namespace dockyard::raposa {

/// Blue paint round the edges of a square that stands upright, its middle at the guide's height. It
/// is as wide on both faces of an edge: from x = -behind_m forward on the pyramid's sides, and from
/// there on the faces that rise towards the rod.
struct MarksModel {
  double edge_m = 0.0, behind_m = 0.0, strip_m = 0.0;
  double rise_rad = 0.0;
};

/// Two cones base to base on a rod.
struct GuideModel {
  double diameter_m = 0.0, length_m = 0.0;
  double half_angle_rad = 0.0;
  double height_m = 0.0;  // of its middle above level ground
  double up_rad = 0.0;    // of its axis above the level
  double rod_radius_m = 0.0;
  double blunt_radius_m = 0.0;  // where its front ends
};

/// Its far end is fixed.
struct TetherCableModel {
  double length_m = 0.0, slack_m = 0.0;
  double mass_kg_per_m = 0.0, diameter_m = 0.0, axial_stiffness_n = 0.0;
  double damping_ns_per_m = 0.0;  // of its length
  double friction_on_ground = 0.0;
};

struct PyramidModel {
  std::string name;
  LinkModel body;
  MarksModel marks;
  GuideModel guide;
  std::vector<Eigen::Vector2d> p_P_soles;  // x, y; at the height of the ground
  double foot_friction = 0.0, foot_stiffness_n_per_m = 0.0;
  double foot_damping_ratio = 0.0;  // share of critical
  double foot_diameter_m = 0.0;     // by which the feet sink into soil
  TetherCableModel cable;
};

}  // namespace dockyard::raposa
