// The nominal parameters of a robot and a dock that are described by files.
#pragma once

#include "controller/custom/nominal/nominal.h"
#include "models/custom/dock_model.h"
#include "models/custom/robot_model.h"

namespace dockyard::custom {

/// Without the frames that meet when docked, the sensors, the contact and the options: those are
/// the scenario's.
Nominal MakeNominal(const RobotModel& robot, const DockModel& dock);

}  // namespace dockyard::custom
