// Electrical contacts of a charging dock: spring pins on one body press on pads of another.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

/// A plunger on a spring. Its force over the stroke is a line, as catalogues give it.
struct SpringPin {
  std::string contact, pole;       // "charge", "plus"
  int link = 0;                    // of its body
  Eigen::Vector3d p_L{0, 0, 0};    // of the tip when it is out
  Eigen::Vector3d out_L{1, 0, 0};  // unit; its direction
  double stroke_m = 0.0;
  double first_n = 0.0, last_n = 0.0;  // as it begins to yield, and at the stroke's end
  double friction = 0.2;               // of the tip across; gold on nickel: assumed, 0.1-0.4
  double damping_ns_per_m = 2.0;       // of the plunger in its barrel; assumed, 0.5-10
  double closes_n = 0.0;               // a lighter touch does not conduct
};

/// A conducting plate that a pin must meet.
struct ContactPad {
  std::string contact, pole;
  int link = 0;
  Pose3 X_LP;  // z out of the plate, x and y along its sides; the origin is its middle
  double width_m = 0.0, height_m = 0.0;  // along x and y
};

/// The source behind a contact, and what the robot draws.
struct ContactSupply {
  std::string contact;
  double open_v = 0.0;     // without a load
  double inner_ohm = 0.0;  // of source and cable
  double touch_ohm = 0.0;  // of each pair of pin and pad
  double draws_a = 0.0;    // the robot's charger, in constant current
};

/// Those of one body.
struct ElectricalParts {
  std::vector<SpringPin> pins;
  std::vector<ContactPad> pads;
  std::vector<ContactSupply> supplies;
};

}  // namespace dockyard
