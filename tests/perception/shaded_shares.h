#pragma once

#include <vector>

#include "render/scene.h"

namespace dockyard::axel {

/// By fiducial of the scene's first board: share of the disc from which something hides the sun's
/// middle, 0..1. The ground and the tether cast no shadow here.
std::vector<double> ShadedShares(const Scene& scene);

}  // namespace dockyard::axel
