// Whether a part of the rover that is not the instrument's face is in the boulder. Such contacts
// are not simulated: they end a run.
#pragma once

#include "models/rocky7/robot_model.h"
#include "sim/rigid/star_body.h"
#include "sim/vehicles/wheeled_body.h"

namespace dockyard::rocky7 {

/// Looks at points of wheels, body, panel and mast.
bool MeetsBoulder(const WheeledBody& rover, const RobotModel& robot, const StarBody& boulder_G);

}  // namespace dockyard::rocky7
