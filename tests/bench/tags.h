// AprilTag 3 (Debian's libapriltag-dev) for the comparison: patterns to print, and detections.
#pragma once

#include <apriltag/apriltag.h>

#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/image.h"
#include "render/printed_board.h"

namespace dockyard {

inline constexpr double kTagSize_m = 0.10;    // black edge, as large as a disc
inline constexpr double kTagImage_m = 0.125;  // with the white ring round it

struct SeenTag {
  int id = 0;
  Eigen::Vector2d centre_px{0, 0};  // pixel (0, 0) is the middle of the first
};

/// Family 36h11 with the library's defaults, one thread.
class TagDetector {
 public:
  /// @param decimate  1: full resolution, its longest range; 2: the library's default, faster
  explicit TagDetector(float decimate);
  ~TagDetector();
  TagDetector(const TagDetector&) = delete;
  TagDetector& operator=(const TagDetector&) = delete;

  /// Tag i of the family about fiducial i of the board.
  std::vector<PrintedImage> Images(const FiducialBoard& board) const;
  std::vector<SeenTag> Detect(const GrayImage& image);

 private:
  apriltag_family_t* family_;
  apriltag_detector_t* detector_;
};

}  // namespace dockyard
