// The controller `graceful`: docks a differential robot by marks on its dock, with the smooth
// control law of Park and Kuipers (ICRA 2011).
#pragma once

#include <memory>

#include "controller/base/result.h"
#include "controller/custom/nominal/nominal.h"
#include "controller/custom/refusal.h"
#include "controller/custom/sighting.h"
#include "controller/io/controller.h"

namespace dockyard::custom {

/// Called every control period. Its belief has the phase (phases.h), the robot's pose R in D, and
/// these values: "retries", "dock_sigma_x_m", "dock_sigma_y_m" and "dock_sigma_yaw_deg" of the
/// docked pose, "tag_branches_open" (1 while both poses of a board explain the sightings),
/// "contact_voltage_v" and "contact_closed".
/// Refuses a robot that it cannot drive, a docked pose that it cannot reach, and boards that it
/// cannot detect, with the part and what is expected.
Result<std::unique_ptr<Controller>, Refusal> MakeGracefulController(const Nominal& nominal);

/// The same with a perception of the caller's.
Result<std::unique_ptr<Controller>, Refusal> MakeGracefulController(const Nominal& nominal,
                                                                    Perceive perceive);

}  // namespace dockyard::custom
