// The readings of a sensor of the tether's tension and direction, without their noise.
#pragma once

#include <vector>

#include "controller/axel/nominal/tether_sensor.h"
#include "models/parts/tether_sensor.h"
#include "sim/axel/world.h"
#include "sim/base/random.h"
#include "sim/log/named_sensor.h"

namespace dockyard::axel {

/// With their nominal noise, in the order of SensorFrame::values.
std::vector<NamedSensor> SensorsOf(const TetherSensor& sensor);

/// Without errors, in the same order. The tension at the drum is that at the arm's tip: between
/// them the tether rubs nowhere. The direction is that of a feeler at the tip; on a slack tether
/// it follows the line as it hangs or lies.
std::vector<double> TetherTruth(const Truth& truth);

/// Of one run, whose seed draws the offsets and the scale.
class TetherSensing {
 public:
  TetherSensing(const TetherSensorModel& model, const Seed& run_seed);
  std::vector<double> Read(const Truth& truth) const;

 private:
  double tension_offset_n_ = 0.0, tension_scale_ = 1.0;
  double azimuth_offset_rad_ = 0.0, elevation_offset_rad_ = 0.0;
};

}  // namespace dockyard::axel
