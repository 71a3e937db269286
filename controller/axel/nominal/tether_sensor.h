// A sensor of the tether's tension and direction (Tsai et al., V-F): what a controller knows of it.
#pragma once

#include <cstddef>

namespace dockyard::axel {

/// Where SensorFrame::values has its readings. The tension is that at the drum [N]. The direction
/// is from the arm's tip along the tether, in the body R: the azimuth from x to the left and the
/// elevation above the plane of x and y [rad].
inline constexpr std::size_t kTetherTension = 0, kTetherAzimuth = 1, kTetherElevation = 2;

/// 1 sigma of a reading's noise.
struct TetherSensor {
  double tension_noise_n = 0.0, direction_noise_rad = 0.0;
};

}  // namespace dockyard::axel
