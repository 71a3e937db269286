#include "controller/stereo/match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "controller/base/check.h"
#include "controller/stereo/band_pass_blocks.h"
#include "controller/stereo/gray_mat.h"

namespace dockyard {
namespace {

constexpr int kSubpixels = 16;  // of OpenCV's disparities
constexpr int kSpeckleRange_px = 2;
// Slopes of brightness beyond it count as it. OpenCV's samples have it; with the least cap, 15, 7.0
// % of the pixels of the Aloe pair are off by more than 1 px, else 6.6 %.
constexpr int kSlopeCap = 63;

// The right image as a camera would see it that has the ground at disparity 0.
cv::Mat WithoutGround(const GrayImage& right, const PlaneDisparity& ground) {
  cv::Mat u(right.height, right.width, CV_32F), v(right.height, right.width, CV_32F), out;
  for (int y = 0; y < right.height; ++y) {
    for (int x = 0; x < right.width; ++x) {
      u.at<float>(y, x) = static_cast<float>(x - ground.At(x, y));
      v.at<float>(y, x) = static_cast<float>(y);
    }
  }
  cv::remap(MatOn(right), out, u, v, cv::INTER_CUBIC, cv::BORDER_CONSTANT, 0);
  return out;
}

// The least size of images for a search.
int LeastWidth(const MatchSettings& with) {
  return std::max(0, with.least_px + with.count_px) + std::max(0, -with.least_px) + with.block_px;
}

void Check(const StereoImages& images, const MatchSettings& with) {
  DOCKYARD_CHECK(images.left.width == images.right.width &&
                 images.left.height == images.right.height);
  DOCKYARD_CHECK(with.block_px >= (with.matcher == Matcher::kBlocks ? 5 : 3));
  DOCKYARD_CHECK(with.block_px % 2 == 1 && with.count_px >= 16 && with.count_px % 16 == 0);
  DOCKYARD_CHECK(with.smooth_px >= 0.0 && with.smooth_px <= 5.0);
}

cv::Mat Smoothed(const cv::Mat& image, double sigma_px) {
  if (sigma_px <= 0.0) return image;
  cv::Mat out;
  cv::GaussianBlur(image, out, {}, sigma_px);
  return out;
}

cv::Mat Search(const cv::Mat& left, const cv::Mat& right, const MatchSettings& with) {
  cv::Mat found;
  if (with.matcher == Matcher::kBlocks) {
    const auto matcher = cv::StereoBM::create(with.count_px, with.block_px);
    matcher->setMinDisparity(with.least_px);
    matcher->setUniquenessRatio(with.uniqueness_percent);
    matcher->setDisp12MaxDiff(with.most_left_right_px);
    matcher->setSpeckleWindowSize(with.speckle_px);
    matcher->setSpeckleRange(kSpeckleRange_px);
    matcher->compute(left, right, found);
    return found;
  }
  if (with.matcher == Matcher::kBandPassed) {
    found = MatchBandPassed(left, right,
                            {with.block_px, with.least_px, with.count_px, with.most_left_right_px});
    cv::filterSpeckles(found, kSubpixels * (with.least_px - 1), with.speckle_px,
                       kSubpixels * kSpeckleRange_px);
    return found;
  }
  const int block2 = with.block_px * with.block_px;  // costs as OpenCV's samples have them
  const auto matcher =
      cv::StereoSGBM::create(with.least_px, with.count_px, with.block_px, 8 * block2, 32 * block2,
                             with.most_left_right_px, kSlopeCap, with.uniqueness_percent,
                             with.speckle_px, kSpeckleRange_px, cv::StereoSGBM::MODE_SGBM_3WAY);
  matcher->compute(left, right, found);
  return found;
}

}  // namespace

std::string WhyNoSearch(int width, int height, const MatchSettings& with) {
  // OpenCV's blocks must be smaller than the image.
  const int least_px = LeastWidth(with), least_height_px = with.block_px + 1;
  if (width >= least_px && height >= least_height_px) return "";
  return "a search of " + std::to_string(with.count_px) + " disparities by blocks of " +
         std::to_string(with.block_px) + " px needs rectified images of at least " +
         std::to_string(least_px) + " x " + std::to_string(least_height_px) + " px, these have " +
         std::to_string(width) + " x " + std::to_string(height);
}

PlaneDisparity DisparityOf(const RectifiedPair& pair, const Plane& plane_R) {
  const Eigen::Vector3d normal = pair.X_RC.R.transpose() * plane_R.normal;
  const double offset_m = plane_R.offset_m - plane_R.normal.dot(pair.X_RC.p);
  if (offset_m == 0.0) throw std::invalid_argument("a plane through the camera has no disparity");
  // A ray's depth on the plane is offset / (normal . ray).
  const Eigen::Vector3d scaled = pair.baseline_m / offset_m * normal;
  const Eigen::Vector2d centre = pair.centre_px;
  return {pair.focal_px * scaled.z() - scaled.head<2>().dot(centre) - pair.doffs_px, scaled.x(),
          scaled.y()};
}

Disparities Match(const StereoImages& rectified, const MatchSettings& with) {
  Check(rectified, with);
  const PlaneDisparity ground = with.ground.value_or(PlaneDisparity{});
  const cv::Mat right =
      with.ground ? WithoutGround(rectified.right, ground) : MatOn(rectified.right);
  const cv::Mat found = Search(Smoothed(MatOn(rectified.left), with.smooth_px),
                               Smoothed(right, with.smooth_px), with);
  Disparities out{found.cols, found.rows, {}};
  out.px.reserve(found.total());
  const int none = kSubpixels * (with.least_px - 1);
  for (int v = 0; v < found.rows; ++v) {
    for (int u = 0; u < found.cols; ++u) {
      const short raw = found.at<short>(v, u);
      const double rest = static_cast<double>(raw) / kSubpixels;
      const double all = rest + ground.At(u - rest, v);
      const bool usable = raw > none && all > 0.0;
      out.px.push_back(usable ? static_cast<float>(all) : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return out;
}

Disparities Match(const Rectifier& rectifier, const StereoImages& images,
                  const MatchSettings& with) {
  Disparities found = Match(rectifier.Rectified(images), with);
  const int margin_px = with.block_px / 2;
  std::size_t place = 0;
  for (int v = 0; v < found.height; ++v) {
    for (int u = 0; u < found.width; ++u, ++place) {
      float& px = found.px[place];
      if (std::isnan(px)) continue;
      const int right_u = static_cast<int>(std::lround(static_cast<float>(u) - px));
      if (!rectifier.IsSeen(u, v, false, margin_px) ||
          !rectifier.IsSeen(right_u, v, true, margin_px)) {
        px = std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  return found;
}

}  // namespace dockyard
