// The rover's data sheet as JSON, so that a log holds all that its controller was given.
#pragma once

#include "controller/io/rover_sheet.h"
#include "sim/log/json_io.h"

namespace dockyard {

Json ToJson(const RoverSheet& sheet);
/// Every number as it was, bit for bit. Throws LogError for a lens model or vision pipeline that it
/// does not know, nlohmann::json::exception for what else it cannot read.
RoverSheet SheetFromJson(const Json& json);

}  // namespace dockyard
