// models/wheels/*.yaml -> a single wheel, as the rig of `dockyard wheel` drives it.
#pragma once

#include <string>

#include "models/parts/wheel.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

struct WheelFile {
  std::string name;
  std::string source;  // of the numbers
  WheelModel wheel;
};

/// Throws ConfigError.
WheelFile LoadWheel(const std::string& file);

/// Reads the mapping `paddles` of a mapping, phase zero.
void ReadPaddles(const YamlReader& in, WheelModel& wheel);

/// Reads radius_m, width_m and paddles of a mapping that has them, phase zero.
WheelModel ReadWheelShape(const YamlReader& in);

}  // namespace dockyard
