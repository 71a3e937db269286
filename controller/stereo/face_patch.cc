#include "controller/stereo/face_patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "controller/stereo/gray_mat.h"

namespace dockyard {
namespace {

// Another peak lies so far from the best one, of the patch's half side. Assumed, 0.2-0.5.
constexpr double kOtherPeak = 0.3;
// Greys of a face lie within so many sigmas. Assumed, 2-3.
constexpr double kOfFace = 2.5;

// Pixels of the older picture for those of the new one: p_N = (R + t n^T / d) p_C on n . p_C = d.
Eigen::Matrix3d OlderFromNew(const FacePatch& patch, const Pose3& X_NC) {
  const double offset_m = patch.normal_C.dot(patch.p_C);
  const Eigen::Matrix3d M = X_NC.R + X_NC.p * patch.normal_C.transpose() / offset_m;
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();
  K(0, 0) = K(1, 1) = patch.focal_px;
  K.topRightCorner<2, 1>() = patch.centre_px;
  return K * M.inverse() * K.inverse();
}

// The vertex of the parabola through three values, from the middle one.
double Vertex(double before, double at, double after) {
  const double bend = before - 2.0 * at + after;
  if (bend >= 0.0) return 0.0;
  return std::clamp(0.5 * (before - after) / bend, -0.5, 0.5);
}

}  // namespace

PatchFound FindPatch(const FacePatch& patch, const GrayImage& image, const Pose3& X_NC,
                     double window_px, const FacePatchSettings& settings) {
  PatchFound found;
  const Eigen::Vector3d p_N = X_NC * patch.p_C;
  if (p_N.z() <= 0.0) return found;
  const Eigen::Vector2d at = patch.centre_px + patch.focal_px * p_N.head<2>() / p_N.z();
  const int half =
      std::clamp(static_cast<int>(std::lround(patch.focal_px * settings.half_m / p_N.z())),
                 settings.least_half_px, settings.most_half_px);
  const int side = 2 * half + 1;
  const int u0 = static_cast<int>(std::lround(at.x())), v0 = static_cast<int>(std::lround(at.y()));
  const int reach = half + static_cast<int>(std::ceil(window_px));
  const int left = std::max(0, u0 - reach), top = std::max(0, v0 - reach);
  const int right = std::min(image.width - 1, u0 + reach);
  const int bottom = std::min(image.height - 1, v0 + reach);
  if (right - left + 1 < side + 2 || bottom - top + 1 < side + 2) return found;

  // The older picture as seen from the new place, about the point's predicted pixel.
  Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
  shift(0, 2) = u0 - half;
  shift(1, 2) = v0 - half;
  const Eigen::Matrix3d H = OlderFromNew(patch, X_NC) * shift;
  for (const double u : {0.0, side - 1.0}) {
    for (const double v : {0.0, side - 1.0}) {
      const Eigen::Vector3d older = H * Eigen::Vector3d(u, v, 1.0);
      if (older.z() <= 0.0) return found;
      const Eigen::Vector2d pixel = older.head<2>() / older.z();
      if (pixel.minCoeff() < 0.0 || pixel.x() > patch.left.width - 1.0 ||
          pixel.y() > patch.left.height - 1.0) {
        return found;
      }
    }
  }
  cv::Mat map(3, 3, CV_64F), seen, scores;
  for (int i = 0; i < 9; ++i) map.at<double>(i / 3, i % 3) = H(i / 3, i % 3);
  cv::warpPerspective(MatOn(patch.left), seen, map, {side, side},
                      cv::INTER_CUBIC | cv::WARP_INVERSE_MAP);
  // The face's own greys, by the patch's inner part. What is far brighter or darker beside it is
  // another surface: sky and sunlit ground behind a boulder's edge would outweigh its stains.
  const int inner = half / 2;
  cv::Scalar mean, sigma;
  cv::meanStdDev(seen(cv::Rect(half - inner, half - inner, 2 * inner + 1, 2 * inner + 1)), mean,
                 sigma);
  found.verdict = PatchVerdict::kPlain;
  if (sigma[0] < settings.least_contrast) return found;
  cv::Mat face;
  cv::inRange(seen, mean - kOfFace * sigma, mean + kOfFace * sigma, face);
  const cv::Mat window = MatOn(image)(cv::Range(top, bottom + 1), cv::Range(left, right + 1));
  cv::matchTemplate(window, seen, scores, cv::TM_CCOEFF_NORMED, face);
  cv::patchNaNs(scores, -1.0);  // without contrast
  cv::threshold(scores, scores, 1.0, -1.0, cv::THRESH_TOZERO_INV);
  cv::Point best;
  cv::minMaxLoc(scores, nullptr, &found.score, nullptr, &best);
  found.verdict = PatchVerdict::kElsewhere;
  const bool border =
      best.x == 0 || best.y == 0 || best.x == scores.cols - 1 || best.y == scores.rows - 1;
  if (found.score < settings.least_score || border) return found;
  const auto score = [&](int x, int y) { return static_cast<double>(scores.at<float>(y, x)); };
  const double apart = kOtherPeak * half;
  const auto peaks = [&](int x, int y) {  // not the best one's own slope
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (score(x + dx, y + dy) > score(x, y)) return false;
      }
    }
    return true;
  };
  for (int y = 1; y < scores.rows - 1; ++y) {
    for (int x = 1; x < scores.cols - 1; ++x) {
      if (std::hypot(x - best.x, y - best.y) < apart || !peaks(x, y)) continue;
      found.second = std::max(found.second, score(x, y));
    }
  }
  found.verdict = PatchVerdict::kAmbiguous;
  if (found.second > settings.most_second * found.score) return found;
  found.verdict = PatchVerdict::kFound;
  const double centre = score(best.x, best.y);
  const double du = Vertex(score(best.x - 1, best.y), centre, score(best.x + 1, best.y));
  const double dv = Vertex(score(best.x, best.y - 1), centre, score(best.x, best.y + 1));
  // From the patch's middle pixel to the point.
  found.pixel = Eigen::Vector2d(left + best.x + half + du, top + best.y + half + dv) +
                (at - Eigen::Vector2d(u0, v0));
  return found;
}

}  // namespace dockyard
