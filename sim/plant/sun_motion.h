// The light of a moment of a run, where the sun moves.
#pragma once

#include "sim/plant/light.h"

namespace dockyard {

/// Sun and sky `seconds` after the run's start: as at the start where the sun stays. A sun
/// that moves does so every ten seconds, by a twelfth of its diameter, since its shadows on the
/// ground are then made anew. It does not shine once it has set; the sky goes on as it is.
SunAndSky LightAt(const Lighting& lighting, double seconds);

}  // namespace dockyard
