// A dock that is described by files: solids by its URDF, and what a URDF has no word for by a YAML
// file.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "models/parts/contact_material.h"
#include "models/parts/link_tree.h"
#include "models/parts/spring_pins.h"

namespace dockyard::custom {

/// A board of marks on a link.
struct BoardFit {
  std::string name;
  FiducialBoard board;
  int link = 0;
  Pose3 X_LB;         // B: x right and y down as a viewer sees it, z into the dock
  double dust = 0.0;  // mean share of its face under dust
  double wear = 0.0;  // share of the ink that is gone
  // How far its middle is out to its viewer over its edges, below zero a hollow, bent about a
  // cylinder; and the direction in which it bends, from B's x counter-clockwise for its viewer.
  double flatness_m = 0.0, bow_rad = 0.0;
};

/// D: the root link's frame, on the ground; x out to where robots come from, z up.
struct DockModel {
  std::string name;
  LinkTree tree;
  bool fixed = false;       // in the ground, as one that is screwed to a wall
  double floor_grip = 0.8;  // of its feet on the floor, a share of rubber's; assumed, 0.4-1
  // Of its solids and the robot's on each other. Plastic housings: assumed, 2e4-5e5, 20-500 and
  // 0.2-0.5.
  ContactMaterial contact{.stiffness_n_per_m = 1e5, .damping_ns_per_m = 100.0, .friction = 0.3};
  std::vector<BoardFit> boards;
  ElectricalParts electrical;
  Pose2 X_DD_built;  // where it is put, off its nominal place
};

}  // namespace dockyard::custom
