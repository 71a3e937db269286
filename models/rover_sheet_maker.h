// The data sheet that the rover's brain gets, from the models' nominal numbers.
#pragma once

#include "controller/io/rover_sheet.h"
#include "models/rover_model.h"
#include "models/station_model.h"

namespace dockyard {

/// Nominal: the stereo rig as drawn, not as built. `arm_at_zero_rad` is the arm's angle at
/// power-on, which a rover knows from its stowed position.
RoverSheet MakeRoverSheet(const RoverModel& rover, const StationModel& station,
                          double arm_at_zero_rad);
/// With the arm as the rover's file has it at power-on.
RoverSheet MakeRoverSheet(const RoverModel& rover, const StationModel& station);

}  // namespace dockyard
