#include "controller/vision/tags/aruco_finder.h"

#include <opencv2/aruco.hpp>
#include <opencv2/core.hpp>

#include "controller/base/check.h"
#include "controller/vision/tags/aruco_families.h"

namespace dockyard {

std::vector<FoundTag> FindAruco(const GrayImage& image, const std::string& family) {
  [[maybe_unused]] static const bool single = (cv::setNumThreads(1), true);
  const cv::Ptr<cv::aruco::Dictionary> dictionary = ArucoFamilyNamed(family);
  DOCKYARD_CHECK(!dictionary.empty());
  constexpr int kLeastSide_px = 16;  // OpenCV's windows are up to 23 px, smaller images have no tag
  if (image.width < kLeastSide_px || image.height < kLeastSide_px) return {};
  const cv::Ptr<cv::aruco::DetectorParameters> parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  // Half the window. The default of 5 px reaches into the squares of small tags.
  parameters->cornerRefinementWinSize = 2;
  // Part of a square left out on each side. The default of 0.13 reads the blur of neighbours where
  // squares have 2 px: tags of 0.1 m and 4 x 4 bits were lost from 2 m on at 90 deg and 640 px.
  parameters->perspectiveRemoveIgnoredMarginPerCell = 0.3;
  // Data is only read, but cv::Mat has no type for that.
  const cv::Mat view(image.height, image.width, CV_8UC1,
                     const_cast<std::uint8_t*>(image.pixels.data()));
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(view, dictionary, corners, ids, parameters);
  std::vector<FoundTag> found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    FoundTag one{.id = ids[i], .corners = {}};
    for (std::size_t k = 0; k < 4; ++k) one.corners[k] = {corners[i][k].x, corners[i][k].y};
    found.push_back(one);
  }
  return found;
}

}  // namespace dockyard
