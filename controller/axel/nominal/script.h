// Open-loop commands for Axel, as a scenario's `script` gives them.
#pragma once

#include <optional>

namespace dockyard::axel {

/// The motors' commands for a time.
struct ScriptStep {
  double for_s = 0.0;
  double speed_m_s = 0.0, turn_rad_s = 0.0;  // of the axle's middle; wheels driven to match
  bool free_wheels = false;                  // instead of driven
  double reel_m_s = 0.0;                     // in is positive
  std::optional<double> tension_n;           // the winch's limit; none: the drive's own
  std::optional<double> arm_rad;             // against the body, tip-down; none: it holds
  std::optional<double> arm_speed_rad_s;     // on the way there; none: the drive's own
};

}  // namespace dockyard::axel
