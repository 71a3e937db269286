// The nominal parameters that the controller gets, made from the models.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"
#include "models/parts/gravity.h"

namespace dockyard::axel {

/// Nominal: the stereo rig as drawn, not as built. `arm_at_zero_rad` is the arm's angle at
/// power-on; a rover knows it from its stowed position. `gravity_m_s2`: nominal, of the place.
Nominal MakeNominal(const RoverModel& rover, const StationModel& station, double arm_at_zero_rad,
                    double gravity_m_s2 = kEarthGravity_m_s2);
/// With the arm as the rover's file has it at power-on.
Nominal MakeNominal(const RoverModel& rover, const StationModel& station);

}  // namespace dockyard::axel
