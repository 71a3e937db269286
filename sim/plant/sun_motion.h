// The light of a moment of a run, where the sun moves.
#pragma once

#include <optional>

#include "sim/plant/light.h"

namespace dockyard {

/// Sun and sky `seconds` after the run's start: as at the start where the sun stays. A sun
/// that moves does so every ten seconds, by a twelfth of its diameter, since its shadows on the
/// ground are then made anew. It does not shine once it has set; the sky goes on as it is. With an
/// opacity both fade with the sun's height, the sky until the sun is 2 deg high.
/// @param to_pole_W  about which the sun turns; none: it stays
SunAndSky LightAt(const SunAndSky& start, const std::optional<Eigen::Vector3d>& to_pole_W,
                  double seconds);
inline SunAndSky LightAt(const Lighting& lighting, double seconds) {
  return LightAt(lighting.sun_and_sky, lighting.to_pole_W, seconds);
}

}  // namespace dockyard
