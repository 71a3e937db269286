// Axel's nominal parameters as JSON, so that a log holds all that its controller was told.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "sim/base/json.h"

namespace dockyard::axel {

Json ToJson(const Nominal& nominal);
/// Every number as it was, bit for bit. Throws ConfigError when it is not Axel's.
Nominal NominalFromJson(const Json& json);

}  // namespace dockyard::axel
