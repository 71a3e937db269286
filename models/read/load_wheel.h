// models/wheels/*.yaml -> a single wheel, as the rig of `dockyard wheel` drives it.
#pragma once

#include <string>

#include "models/parts/wheel.h"
#include "models/read/keys.h"

namespace dockyard {

struct WheelFile {
  std::string name;
  std::string source;  // of the numbers
  WheelModel wheel;
};

/// Throws ConfigError.
WheelFile LoadWheel(const std::string& file);

/// Names the mapping `paddles` of a mapping.
void VisitPaddles(Keys& keys, WheelModel& wheel);

/// Names radius_m, width_m and paddles of a mapping that has them.
void VisitWheelShape(Keys& keys, WheelModel& wheel);

}  // namespace dockyard
