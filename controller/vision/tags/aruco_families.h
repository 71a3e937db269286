// Internal to the tags room. The dictionaries of OpenCV's aruco by their names.
#pragma once

#include <opencv2/aruco/dictionary.hpp>
#include <string>
#include <vector>

namespace dockyard {

std::vector<std::string> ArucoFamilyNames();
/// Null for a name that is not in ArucoFamilyNames.
cv::Ptr<cv::aruco::Dictionary> ArucoFamilyNamed(const std::string& name);

}  // namespace dockyard
