// A flat plate pressed into the soil. It sinks by Bekker's law and keeps its depth when the load
// goes, but for an elastic rebound.
#pragma once

#include "models/parts/soil_model.h"

namespace dockyard {

struct SinkingPlate {
  double force_n_per_m_n = 0.0;  // force = this times depth^n; 0: it does not sink
  double n = 1.0;
  double rebound_n_per_m = 0.0;  // of unloading and of loading again
};

/// Bekker's b is the radius of a round plate (Wong, Theory of Ground Vehicles, 4th ed.,
/// 2008, 2.4.1).
SinkingPlate RoundPlate(const SoilModel& soil, double diameter_m);

/// Depth under a load that only grew [m].
double DepthUnder(const SinkingPlate& plate, double force_n);

/// The soil's force on a plate at this depth [N]. sunk_m is the depth that stays when the load
/// goes; it grows where the load exceeds what the soil bore before.
double PressPlate(const SinkingPlate& plate, double depth_m, double& sunk_m);

}  // namespace dockyard
