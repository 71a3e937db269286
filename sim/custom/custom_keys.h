// The keys of a scenario under `custom`, which may be at its root: dock, judge, graceful.
#pragma once

#include "controller/custom/nominal/docking.h"
#include "sim/custom/judge_keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::custom {

struct CustomKeys {
  std::string dock_file;
  JudgeKeys judge;
  // The robot's start heading off the dock; NaN: start.heading_deg counts.
  double off_dock_rad = kNotAsked;
  DockingOptions docking;  // of the controller `graceful`
};

/// Names every key.
void VisitCustomKeys(Keys& keys, CustomKeys& values);
/// Reads and checks them. Throws ConfigError.
CustomKeys ReadCustomKeys(const Scenario& scenario);

}  // namespace dockyard::custom
