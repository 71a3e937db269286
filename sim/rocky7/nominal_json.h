// Rocky 7's nominal parameters as JSON, for logs and for controllers in other processes.
#pragma once

#include "controller/rocky7/nominal/nominal.h"
#include "sim/base/json.h"

namespace dockyard::rocky7 {

Json ToJson(const Nominal& nominal);
/// Throws ConfigError when they are those of another system.
Nominal NominalFromJson(const Json& json);

}  // namespace dockyard::rocky7
