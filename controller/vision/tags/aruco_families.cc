#include "controller/vision/tags/aruco_families.h"

#include <algorithm>

namespace dockyard {

// In the order of OpenCV's numbers: DICT_4X4_50 is 0, DICT_ARUCO_ORIGINAL is 16.
std::vector<std::string> ArucoFamilyNames() {
  std::vector<std::string> names;
  for (const char* bits : {"4x4", "5x5", "6x6", "7x7"}) {
    for (const char* ids : {"50", "100", "250", "1000"}) {
      names.push_back(std::string("aruco_") + bits + "_" + ids);
    }
  }
  names.push_back("aruco_original");
  return names;
}

cv::Ptr<cv::aruco::Dictionary> ArucoFamilyNamed(const std::string& name) {
  const std::vector<std::string> names = ArucoFamilyNames();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) return {};
  return cv::aruco::getPredefinedDictionary(static_cast<int>(at - names.begin()));
}

}  // namespace dockyard
