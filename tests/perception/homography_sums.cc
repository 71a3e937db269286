#include "perception/homography_sums.h"

#include <cmath>
#include <cstdio>

#include "controller/vision/homography.h"

namespace dockyard::axel {
namespace {

double Sum(const std::vector<PlanePair>& pairs) {
  const auto H = FitHomography(pairs);
  if (!H) return 0.0;
  double sum = 0.0;
  for (const PlanePair& pair : pairs) {
    const auto at = Map(*H, pair.board);
    if (at) sum += (*at - pair.image).norm();
  }
  return sum;
}

}  // namespace

std::array<HomographySum, 2> HomographySums(const SightingReport& report,
                                            const StereoRig& calibration,
                                            const FiducialBoard& board) {
  std::array<HomographySum, 2> sums;
  for (const bool right : {false, true}) {
    const Camera& camera = right ? calibration.right : calibration.left;
    std::vector<PlanePair> raw, linear;
    for (const SightingReport::Mark& mark : report.marks) {
      if ((mark.camera == 1) != right) continue;
      const Eigen::Vector2d on_board = board.fiducials[static_cast<std::size_t>(mark.id)].p_BF;
      const Eigen::Vector2d pixel(mark.u_px, mark.v_px);
      const Eigen::Vector3d ray_C = camera.Direction(pixel);
      raw.push_back({on_board, pixel});
      linear.push_back({on_board, camera.focal_px().x() / ray_C.z() * ray_C.head<2>()});
    }
    if (raw.size() < 5) continue;
    sums[right ? 1 : 0] = {static_cast<int>(raw.size()), Sum(raw), Sum(linear)};
  }
  return sums;
}

std::string SumsText(const std::vector<HomographySum>& sums) {
  int images = 0, marks = 0;
  double raw = 0.0, raw2 = 0.0, linear = 0.0;
  for (const HomographySum& sum : sums) {
    if (sum.marks < 6) continue;
    ++images;
    marks += sum.marks;
    raw += sum.raw_px;
    raw2 += sum.raw_px * sum.raw_px;
    linear += sum.linear_px;
  }
  if (images == 0) return "no image with six marks";
  const double mean = raw / images;
  char text[200];
  std::snprintf(text, sizeof text,
                "%d images: sum %.2f +- %.2f px, %.2f a mark; without the lens %.2f px", images,
                mean, std::sqrt(std::max(raw2 / images - mean * mean, 0.0)), raw / marks,
                linear / images);
  return text;
}

}  // namespace dockyard::axel
