// What Rocky 7's controllers are told of it.
#pragma once

#include "controller/rocky7/nominal/nominal.h"
#include "models/rocky7/robot_model.h"

namespace dockyard::rocky7 {

/// All but the task: reach and click.
Nominal MakeNominal(const RobotModel& robot);

}  // namespace dockyard::rocky7
