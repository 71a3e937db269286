// What moves before Axel's cameras while their shutter is open.
#pragma once

#include "sim/axel/build_run.h"
#include "sim/axel/world.h"

namespace dockyard::axel {

/// The truth seconds later, or earlier, for the eye alone: body, wheels and arm go on at their
/// velocities, and the tether and the station stay. For some milliseconds.
Truth MovedOn(const Truth& truth, double seconds);

/// Way of the board in the images in some seconds, as of an exposure, at most [px]. Nearer than
/// 0.3 m it counts as at 0.3 m.
double BoardMotion_px(const Truth& truth, const BuiltRun& built, double seconds);

}  // namespace dockyard::axel
