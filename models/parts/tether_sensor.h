// A sensor of a tether's tension and direction, and its errors.
#pragma once

namespace dockyard {

/// Each run draws offset and scale, every reading its noise; all 1 sigma. Those of the direction
/// are of each of its two angles.
struct TetherSensorModel {
  double tension_noise_n = 0.0, tension_offset_n = 0.0;
  double tension_scale_share = 0.0;  // error of the tension's scale
  double direction_noise_rad = 0.0, direction_offset_rad = 0.0;
};

}  // namespace dockyard
