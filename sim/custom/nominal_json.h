// The nominal parameters as JSON, for logs and for controllers in other processes.
#pragma once

#include "controller/custom/nominal/nominal.h"
#include "sim/base/json.h"

namespace dockyard::custom {

Json ToJson(const Nominal& nominal);
/// Throws ConfigError when they are those of another system.
Nominal NominalFromJson(const Json& json);

}  // namespace dockyard::custom
