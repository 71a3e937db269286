// Internal to the tags room. Tags by OpenCV's aruco.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/vision/tags/found_tag.h"

namespace dockyard {

/// hamming and decision_margin are left to ReadCells.
/// @param family  one of ArucoFamilyNames
std::vector<FoundTag> FindAruco(const GrayImage& image, const std::string& family);

}  // namespace dockyard
