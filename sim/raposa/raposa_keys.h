// The keys of a scenario under `raposa`.
#pragma once

#include <limits>
#include <string>

#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::raposa {

struct RaposaKeys {
  std::string pyramid_file;   // resolved path
  double light_k = 5000.0;    // colour temperature of the light
  double balance_k = 5000.0;  // the camera is balanced for; NaN: it balances by itself
  double cable_rad = std::numeric_limits<double>::quiet_NaN();  // NaN: drawn
};

/// Names every key: for reading, and for docs/raposa.md.
void VisitRaposaKeys(Keys& keys, RaposaKeys& values);
/// Reads and checks them. Throws ConfigError.
RaposaKeys ReadRaposaKeys(const Scenario& scenario);

}  // namespace dockyard::raposa
