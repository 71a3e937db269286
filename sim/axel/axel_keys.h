// What a scenario may say under the key `axel`.
#pragma once

#include <limits>
#include <string>

#include "controller/io/vision_settings.h"
#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

struct AxelKeys {
  std::string station_file;  // resolved path
  VisionSettings vision{};   // what the controller's perception runs
  double tip_angle_rad =
      std::numeric_limits<double>::quiet_NaN();  // of the cone; NaN: as the station's file says
  double board_dust = 0.0;                       // mean share of the board's face under dust
};

/// Names every key: for reading, and for docs/reference/scenarios.md.
void VisitAxelKeys(Keys& keys, AxelKeys& values);
/// Reads and checks them. Throws ConfigError.
AxelKeys ReadAxelKeys(const Scenario& scenario);

}  // namespace dockyard::axel
