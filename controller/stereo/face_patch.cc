#include "controller/stereo/face_patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "controller/stereo/gray_mat.h"

namespace dockyard {
namespace {

// Another peak lies so far from the best one, of the patch's half side. Assumed, 0.2-0.5.
constexpr double kOtherPeak = 0.3;
// The place that the surroundings choose must look as good by this share. Assumed, 0.85-0.95.
constexpr double kAsGood = 0.9;
// Greys are compared with those about them, in a square of half the patch's half side; of noise,
// 1 sigma in grey. Assumed, 5-11 px and 1-4.
constexpr int kLeastAbout_px = 7;
constexpr float kSensorNoise = 2.0F;
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

// The older picture as seen from the new place, about a pixel there; none beyond its borders.
std::optional<cv::Mat> SeenFromNew(const FacePatch& patch, const Pose3& X_NC,
                                   const Eigen::Vector2i& middle, int half) {
  const int side = 2 * half + 1;
  Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
  shift(0, 2) = middle.x() - half;
  shift(1, 2) = middle.y() - half;
  const Eigen::Matrix3d H = OlderFromNew(patch, X_NC) * shift;
  for (const double u : {0.0, side - 1.0}) {
    for (const double v : {0.0, side - 1.0}) {
      const Eigen::Vector3d older = H * Eigen::Vector3d(u, v, 1.0);
      if (older.z() <= 0.0) return std::nullopt;
      const Eigen::Vector2d pixel = older.head<2>() / older.z();
      if (pixel.minCoeff() < 0.0 || pixel.x() > patch.left.width - 1.0 ||
          pixel.y() > patch.left.height - 1.0) {
        return std::nullopt;
      }
    }
  }
  cv::Mat map(3, 3, CV_64F), seen;
  for (int i = 0; i < 9; ++i) map.at<double>(i / 3, i % 3) = H(i / 3, i % 3);
  cv::warpPerspective(MatOn(patch.left), seen, map, {side, side},
                      cv::INTER_CUBIC | cv::WARP_INVERSE_MAP);
  return seen;
}

// Each grey against those about it, over their contrast: stains count alike in light and in shade,
// and a shadow's edge no more than they do.
cv::Mat LocallyNormal(const cv::Mat& greys, int about_px) {
  cv::Mat grey, mean, square, out;
  greys.convertTo(grey, CV_32F);
  const cv::Size about(about_px, about_px);
  cv::blur(grey, mean, about);
  cv::blur(grey.mul(grey), square, about);
  cv::Mat variance = cv::max(square - mean.mul(mean), 0.0F) + kSensorNoise * kSensorNoise;
  cv::sqrt(variance, variance);
  cv::divide(grey - mean, variance, out);
  return out;
}

enum class Greys : std::uint8_t { kAsTheyAre, kLocal };

struct Compared {
  PatchVerdict verdict = PatchVerdict::kUnseen;
  cv::Mat scores;
  Eigen::Vector2i first{0, 0};  // the patch's middle at the first place
  cv::Point best;
  double score = 0.0, second = 0.0;
};

// Another peak than the best one's own slope.
double SecondPeak(const cv::Mat& scores, const cv::Point& best, double apart) {
  double second = 0.0;
  for (int y = 1; y < scores.rows - 1; ++y) {
    for (int x = 1; x < scores.cols - 1; ++x) {
      const float here = scores.at<float>(y, x);
      if (here <= second || std::hypot(x - best.x, y - best.y) < apart) continue;
      double most = 0.0;
      cv::minMaxLoc(scores(cv::Rect(x - 1, y - 1, 3, 3)), nullptr, &most);
      if (most <= here) second = here;
    }
  }
  return second;
}

Compared Compare(const FacePatch& patch, const GrayImage& image, const Pose3& X_NC,
                 const Eigen::Vector2i& middle, int half, double window_px,
                 const FacePatchSettings& settings, Greys greys = Greys::kAsTheyAre) {
  Compared out;
  const int reach = half + static_cast<int>(std::ceil(window_px));
  const int left = std::max(0, middle.x() - reach), top = std::max(0, middle.y() - reach);
  const int right = std::min(image.width - 1, middle.x() + reach);
  const int bottom = std::min(image.height - 1, middle.y() + reach);
  if (std::min(right - left, bottom - top) < 2 * half + 2) return out;
  const auto seen = SeenFromNew(patch, X_NC, middle, half);
  if (!seen) return out;
  // The face's own greys, by the patch's inner part. What is far brighter or darker beside it is
  // another surface: sky and sunlit ground behind a boulder's edge would outweigh its stains.
  const int inner = half / 2;
  cv::Scalar mean, sigma;
  cv::meanStdDev((*seen)(cv::Rect(half - inner, half - inner, 2 * inner + 1, 2 * inner + 1)), mean,
                 sigma);
  out.verdict = PatchVerdict::kPlain;
  if (sigma[0] < settings.least_contrast) return out;
  cv::Mat face;
  cv::inRange(*seen, mean - kOfFace * sigma, mean + kOfFace * sigma, face);
  const cv::Mat window = MatOn(image)(cv::Range(top, bottom + 1), cv::Range(left, right + 1));
  if (greys == Greys::kLocal) {
    const int about_px = std::max(kLeastAbout_px, half / 2) | 1;
    cv::matchTemplate(LocallyNormal(window, about_px), LocallyNormal(*seen, about_px), out.scores,
                      cv::TM_CCOEFF_NORMED, face);
  } else {
    cv::matchTemplate(window, *seen, out.scores, cv::TM_CCOEFF_NORMED, face);
  }
  // Where the window has no contrast there is no score, or one without meaning.
  cv::patchNaNs(out.scores, -1.0);
  cv::threshold(out.scores, out.scores, 1.0, -1.0, cv::THRESH_TOZERO_INV);
  cv::minMaxLoc(out.scores, nullptr, &out.score, nullptr, &out.best);
  out.first = {left + half, top + half};
  out.verdict = PatchVerdict::kElsewhere;
  const bool border = out.best.x == 0 || out.best.y == 0 || out.best.x == out.scores.cols - 1 ||
                      out.best.y == out.scores.rows - 1;
  if (out.score < settings.least_score || border) return out;
  out.second = SecondPeak(out.scores, out.best, kOtherPeak * half);
  const bool two = out.second > settings.most_second * out.score;
  out.verdict = two ? PatchVerdict::kAmbiguous : PatchVerdict::kFound;
  return out;
}

// Along a shadow's edge all places look alike. What lies further about tells which one it is, and
// the patch itself where exactly.
void Decide(const Compared& wide, int half, Compared& narrow) {
  if (wide.verdict != PatchVerdict::kFound) return;
  const Eigen::Vector2i at = wide.first + Eigen::Vector2i(wide.best.x, wide.best.y) - narrow.first;
  const int near = static_cast<int>(std::lround(kOtherPeak * half));
  const cv::Rect about = cv::Rect(at.x() - near, at.y() - near, 2 * near + 1, 2 * near + 1) &
                         cv::Rect(1, 1, narrow.scores.cols - 2, narrow.scores.rows - 2);
  if (about.empty()) return;
  double score = 0.0;
  cv::Point best;
  cv::minMaxLoc(narrow.scores(about), nullptr, &score, nullptr, &best);
  if (score < kAsGood * narrow.score) return;
  narrow.best = best + about.tl();
  narrow.score = score;
  narrow.verdict = PatchVerdict::kFound;
}

}  // namespace

PatchFound FindPatch(const FacePatch& patch, const GrayImage& image, const Pose3& X_NC,
                     double window_px, const FacePatchSettings& settings) {
  const Eigen::Vector3d p_N = X_NC * patch.p_C;
  if (p_N.z() <= 0.0) return {};
  const Eigen::Vector2d at = patch.centre_px + patch.focal_px * p_N.head<2>() / p_N.z();
  const Eigen::Vector2i middle(static_cast<int>(std::lround(at.x())),
                               static_cast<int>(std::lround(at.y())));
  const int half =
      std::clamp(static_cast<int>(std::lround(patch.focal_px * settings.half_m / p_N.z())),
                 settings.least_half_px, settings.most_half_px);
  Compared compared = Compare(patch, image, X_NC, middle, half, window_px, settings);
  if (compared.verdict == PatchVerdict::kAmbiguous) {
    // Near by, stains on either side of a shadow's edge tell; far away noise hides them so.
    Compared local = Compare(patch, image, X_NC, middle, half, window_px, settings, Greys::kLocal);
    if (local.verdict == PatchVerdict::kFound) compared = std::move(local);
  }
  if (compared.verdict == PatchVerdict::kAmbiguous) {
    Decide(Compare(patch, image, X_NC, middle, 2 * half, window_px, settings), half, compared);
  }
  PatchFound found{.verdict = compared.verdict, .score = compared.score, .second = compared.second};
  if (found.verdict != PatchVerdict::kFound) return found;
  const cv::Point& best = compared.best;
  const auto score = [&](int x, int y) {
    return static_cast<double>(compared.scores.at<float>(y, x));
  };
  const double centre = score(best.x, best.y);
  const double du = Vertex(score(best.x - 1, best.y), centre, score(best.x + 1, best.y));
  const double dv = Vertex(score(best.x, best.y - 1), centre, score(best.x, best.y + 1));
  // From the patch's middle pixel to the point.
  found.pixel =
      Eigen::Vector2d(compared.first.x() + best.x + du, compared.first.y() + best.y + dv) +
      (at - middle.cast<double>());
  return found;
}

}  // namespace dockyard
