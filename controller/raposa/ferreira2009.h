// Autonomous docking of a tracked robot to its tether's end, after Ferreira and Ventura: one back
// camera, two colours, odometry from the belts.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// The controller as published. Called every kControlPeriod; asks for a picture of the back camera
/// each time. Its belief has the state's name as phase ("start" before the first picture, "docked"
/// at the end), the robot's pose R in D (the guide's middle on the ground, x out along its axis)
/// once a pair was seen, and these values: "state" (the paper's number), "alpha_deg" and "r_m" of
/// the last pair, "passes" through region II, "band_changes" so far.
std::unique_ptr<Controller> MakeFerreira2009Controller(const Nominal& nominal);

}  // namespace dockyard::raposa
