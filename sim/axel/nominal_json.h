// Axel's nominal parameters as JSON, so that a log holds all that its controller got.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "sim/base/json.h"

namespace dockyard::axel {

Json ToJson(const Nominal& nominal);
/// Every number keeps its bits. Throws ConfigError when the JSON is not Axel's.
Nominal NominalFromJson(const Json& json);

}  // namespace dockyard::axel
