#include "sim/raposa/raposa_keys.h"

namespace dockyard::raposa {

void VisitRaposaKeys(Keys& keys, RaposaKeys& values) {
  keys.File({"pyramid", "", "the pyramid's file", Presence::kRequired}, values.pyramid_file);
  keys.Number({"light_k", "K",
               "colour temperature of the light: a filament's below 4000, daylight's above"},
              values.light_k, Between(2500.0, 10000.0));
  keys.Number({"balance_k", "K", "colour temperature that the camera is balanced for"},
              values.balance_k, Between(2500.0, 10000.0));
  keys.Degrees({"cable_deg", "deg",
                "from straight behind the pyramid to the cable's far end; else drawn within 40",
                Presence::kUnset},
               values.cable_rad, Between(-90.0, 90.0));
}

RaposaKeys ReadRaposaKeys(const Scenario& scenario) {
  RaposaKeys values;
  ReadKeys(scenario.of_system, "raposa", [&](Keys& keys) { VisitRaposaKeys(keys, values); });
  return values;
}

}  // namespace dockyard::raposa
