// The board of tags in images of the command detect.
#pragma once

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "controller/io/belief.h"
#include "controller/vision/board/locate.h"

namespace dockyard {

/// The pose by the camera that finds more of the board's tags, the left one when the counts are
/// equal. A mark's id is the index of its tag on the board, its pixel the tag's middle. It reports
/// the better one of the two poses of a plane's ambiguity.
SightingReport LocateTagsIn(const StereoImages& images, const StereoRig& rig,
                            const FiducialBoard& board, const ErrorAllowance& errors);

}  // namespace dockyard
