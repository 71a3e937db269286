// Pixels that a lens masks: no ray leads to them.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/camera.h"
#include "sim/app/point_files.h"

namespace dockyard {

/// Throws ConfigError when a point of the file lies at a pixel of its camera that no ray reaches.
void RequirePixelRays(const std::vector<PointFrame>& frames, const StereoRig& rig,
                      const std::string& file);

}  // namespace dockyard
