// The keys of a scenario under `axel`.
#pragma once

#include <limits>
#include <string>

#include "controller/io/vision_settings.h"
#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

struct AxelKeys {
  std::string station_file;  // resolved path
  VisionSettings vision{};   // of the controller's perception
  double tip_angle_rad =
      std::numeric_limits<double>::quiet_NaN();  // of the cone; NaN: as in the station's file
  double board_dust = 0.0;                       // mean share of the board's face under dust
};

/// Names every key: for reading, and for docs/reference/scenarios.md.
void VisitAxelKeys(Keys& keys, AxelKeys& values);
/// Reads and checks them. Throws ConfigError.
AxelKeys ReadAxelKeys(const Scenario& scenario);

}  // namespace dockyard::axel
