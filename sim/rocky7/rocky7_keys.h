// The keys of a scenario under `rocky7`.
#pragma once

#include <limits>
#include <string>

#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::rocky7 {

struct Rocky7Keys {
  std::string task = "reach";
  // The target: a stone at the origin of D; to be grasped it lies loose on the ground. 3-5 cm
  // (Nesnas, Maimone and Das 2000).
  double diameter_m = 0.04;
  double height_m = 0.02;  // over the ground; of its diameter one half (assumed, 0.3-0.7)
  double buried = 0.1;     // share of its height in the ground; assumed, 0-0.3
  double turn_rad = 0.0;   // about the vertical
  // The rover's start heading off the target; NaN: start.heading counts.
  double off_target_rad = std::numeric_limits<double>::quiet_NaN();
  double reach_m = 0.01;  // how near the point P must come: "to within 1 cm"
  double click_px = 1.5;  // of the user's click, 1 sigma along each side; assumed, 0.5-4
};

/// Names every key: for reading, and for docs/rocky7.md.
void VisitRocky7Keys(Keys& keys, Rocky7Keys& values);
/// Reads and checks them. Throws ConfigError.
Rocky7Keys ReadRocky7Keys(const Scenario& scenario);

}  // namespace dockyard::rocky7
