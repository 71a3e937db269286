// RAPOSA's nominal parameters as JSON: what a log keeps, and what a controller is made from.
#pragma once

#include "controller/raposa/nominal/nominal.h"
#include "sim/base/json.h"

namespace dockyard::raposa {

Json ToJson(const Nominal& nominal);
/// Throws ConfigError when the parameters are not RAPOSA's.
Nominal NominalFromJson(const Json& json);

}  // namespace dockyard::raposa
