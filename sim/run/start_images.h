// The images at the start of a run, for comparing computers: a run's own scene, by a run's own
// path.
#pragma once

#include <string>

#include "sim/run/system.h"

namespace dockyard {

/// A fingerprint of the images that all cameras take at the start, in 16 hexadecimal digits: equal
/// on computers whose images are equal. Empty for a robot without cameras. If nothing can be drawn,
/// or a camera's image is of one value only, "none: " and the reason. Drawn in a process of its
/// own, as RendererFacts does.
std::string StartImages(const System& system, const Scenario& scenario);

}  // namespace dockyard
