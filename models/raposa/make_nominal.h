// What RAPOSA's controllers are told of a robot and its pyramid.
#pragma once

#include "controller/raposa/nominal/nominal.h"
#include "models/raposa/pyramid_model.h"
#include "models/raposa/robot_model.h"

namespace dockyard::raposa {

Nominal MakeNominal(const RobotModel& robot, const PyramidModel& pyramid);

}  // namespace dockyard::raposa
