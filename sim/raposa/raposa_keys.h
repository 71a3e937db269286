// The keys of a scenario under `raposa`.
#pragma once

#include <limits>
#include <string>

#include "models/read/yaml_tree.h"
#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::raposa {

struct RaposaKeys {
  std::string pyramid_file;  // resolved path
  double light_k = 5000.0;   // colour temperature of the light
  // Of the light from all sides: sky or room; NaN: as light_k.
  double fill_light_k = std::numeric_limits<double>::quiet_NaN();
  double light_level = 1.0;   // of sun and sky or room, against a lit room
  double balance_k = 5000.0;  // the camera is balanced for
  bool auto_balance = false;  // it balances by itself, with a lag
  double cable_rad = std::numeric_limits<double>::quiet_NaN();      // NaN: drawn
  double off_guide_rad = std::numeric_limits<double>::quiet_NaN();  // NaN: start.h counts
  double behind_m = 4.0;                                            // of the ground
  int clutter = 0;                                                  // objects
  bool hide_pyramid = false;                                        // it is not drawn
  YamlNode bands{}, band_changes{}, motion{}, vision{};             // kNull: none
};

/// Names every key: for reading, and for docs/raposa.md.
void VisitRaposaKeys(Keys& keys, RaposaKeys& values);
/// Reads and checks them. Throws ConfigError.
RaposaKeys ReadRaposaKeys(const Scenario& scenario);

}  // namespace dockyard::raposa
