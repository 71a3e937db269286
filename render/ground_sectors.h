// Which part of the ground's fan a view can show.
#pragma once

#include "controller/geometry/pose.h"
#include "render/fisheye_warp.h"

namespace dockyard {

/// Sectors first, first + 1, ... (modulo kGroundSectors).
struct SectorRange {
  int first = 0, count = 0;
};

/// X_FC: camera in the fan's frame. Exact for ground at least 0.2 m from the camera; all sectors
/// when the view points steeply up or down, shows the fan's pole, or is from over 1 m from it.
SectorRange VisibleSectors(const Pose3& X_FC, const TanRect& rect);

}  // namespace dockyard
