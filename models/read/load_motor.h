// A motor's mapping in a robot's file -> MotorModel.
#pragma once

#include "models/parts/motor.h"
#include "models/read/keys.h"

namespace dockyard {

/// needed: kRequired, or kDefault where the motor's values so far hold for what is left out.
void VisitMotor(Keys& keys, MotorModel& motor, Presence needed = Presence::kRequired);

}  // namespace dockyard
