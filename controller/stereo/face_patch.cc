#include "controller/stereo/face_patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "controller/stereo/face_greys.h"
#include "controller/stereo/face_warp.h"
#include "controller/stereo/gray_mat.h"
#include "controller/stereo/patch_fit.h"

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
// Both pictures are smoothed by so much, one sigma, as noise hides faint stains; and the new one
// by what a pixel of the older one spans in it. Assumed, 0.7-1.5 px and 0.3-0.6 of a pixel.
constexpr double kSmooth_px = 1.0, kPixelSmooths = 0.5;

// The vertex of the parabola through three values, from the middle one.
double Vertex(double before, double at, double after) {
  const double bend = before - 2.0 * at + after;
  if (bend >= 0.0) return 0.0;
  return std::clamp(0.5 * (before - after) / bend, -0.5, 0.5);
}

cv::Mat SmoothGreys(const cv::Mat& greys, double sigma_px) {
  cv::Mat exact, smooth;
  greys.convertTo(exact, CV_32F);
  cv::GaussianBlur(exact, smooth, {}, sigma_px);
  return smooth;
}

// Each grey against those about it, over their contrast: stains count alike in light and in shade,
// and a shadow's edge no more than they do.
cv::Mat LocallyNormal(const cv::Mat& grey, int about_px) {
  cv::Mat mean, square, out;
  const cv::Size about(about_px, about_px);
  cv::blur(grey, mean, about);
  cv::blur(grey.mul(grey), square, about);
  cv::Mat variance = cv::max(square - mean.mul(mean), 0.0F) + kSensorNoise * kSensorNoise;
  cv::sqrt(variance, variance);
  cv::divide(grey - mean, variance, out);
  return out;
}

enum class Greys : std::uint8_t { kAsTheyAre, kLocal };

// Where a patch is looked for: its middle as predicted, and how far off that may be.
struct Window {
  Eigen::Vector2i middle{0, 0};
  double sigma_px = 0.0, half_px = 0.0;
};

struct Compared {
  PatchVerdict verdict = PatchVerdict::kUnseen;
  cv::Mat scores, odds;
  cv::Mat about, then, face;  // the picture about the place, the patch's greys, what counts of them
  Eigen::Vector2i first{0, 0};  // the patch's middle at the first place
  cv::Point best;
  double score = 0.0, second = 0.0;
};

// Log likelihoods of the places, up to a constant.
cv::Mat OddsOf(const Compared& compared, const Window& window, double independent) {
  cv::Mat odds(compared.scores.size(), CV_32F);
  for (int y = 0; y < odds.rows; ++y) {
    for (int x = 0; x < odds.cols; ++x) {
      const double c = std::clamp<double>(compared.scores.at<float>(y, x), 0.0, 0.999);
      const Eigen::Vector2i off = compared.first + Eigen::Vector2i(x, y) - window.middle;
      odds.at<float>(y, x) =
          static_cast<float>(-0.5 * independent * std::log(1.0 - c * c) -
                             0.5 * off.squaredNorm() / (window.sigma_px * window.sigma_px));
    }
  }
  return odds;
}

// The likeliest place beside the best one's own slope; none: the best one.
cv::Point SecondPeak(const cv::Mat& odds, const cv::Point& best, double apart) {
  cv::Point second = best;
  for (int y = 1; y < odds.rows - 1; ++y) {
    for (int x = 1; x < odds.cols - 1; ++x) {
      const float here = odds.at<float>(y, x);
      if (second != best && here <= odds.at<float>(second)) continue;
      if (std::hypot(x - best.x, y - best.y) < apart) continue;
      double most = 0.0;
      cv::minMaxLoc(odds(cv::Rect(x - 1, y - 1, 3, 3)), nullptr, &most);
      if (most <= here) second = {x, y};
    }
  }
  return second;
}

Compared Compare(const FacePatch& patch, const GrayImage& image, const Pose3& X_NC,
                 const Window& window, int half, const FacePatchSettings& settings,
                 Greys greys = Greys::kAsTheyAre) {
  Compared out;
  const Eigen::Vector2i& middle = window.middle;
  const int reach = half + static_cast<int>(std::ceil(window.half_px));
  const int left = std::max(0, middle.x() - reach), top = std::max(0, middle.y() - reach);
  const int right = std::min(image.width - 1, middle.x() + reach);
  const int bottom = std::min(image.height - 1, middle.y() + reach);
  if (std::min(right - left, bottom - top) < 2 * half + 2) return out;
  const auto seen = WarpedPatch(patch, X_NC, middle, half);
  if (!seen) return out;
  const cv::Mat greys_then = out.then = SmoothGreys(seen->greys, kSmooth_px);
  const auto own = OwnGreys(greys_then, seen->on_face, settings.least_contrast);
  out.verdict = PatchVerdict::kPlain;
  if (!own) return out;
  const cv::Mat& face = out.face = *own;
  const double larger = patch.p_C.z() / (X_NC * patch.p_C).z();
  const double spans = kPixelSmooths * std::sqrt(std::max(0.0, larger * larger - 1.0));
  const cv::Mat about = out.about =
      SmoothGreys(MatOn(image)(cv::Range(top, bottom + 1), cv::Range(left, right + 1)),
                  std::hypot(kSmooth_px, spans));
  if (greys == Greys::kLocal) {
    const int about_px = std::max(kLeastAbout_px, half / 2) | 1;
    cv::matchTemplate(LocallyNormal(about, about_px), LocallyNormal(greys_then, about_px),
                      out.scores, cv::TM_CCOEFF_NORMED, face);
  } else {
    cv::matchTemplate(about, greys_then, out.scores, cv::TM_CCOEFF_NORMED, face);
  }
  // Where the window has no contrast there is no score, or one without meaning.
  cv::patchNaNs(out.scores, -1.0);
  cv::threshold(out.scores, out.scores, 1.0, -1.0, cv::THRESH_TOZERO_INV);
  out.first = {left + half, top + half};
  out.odds = OddsOf(out, window, settings.independent);
  cv::minMaxLoc(out.odds, nullptr, nullptr, nullptr, &out.best);
  out.score = out.scores.at<float>(out.best);
  out.verdict = PatchVerdict::kElsewhere;
  const bool border = out.best.x == 0 || out.best.y == 0 || out.best.x == out.scores.cols - 1 ||
                      out.best.y == out.scores.rows - 1;
  if (out.score < settings.least_score || border) return out;
  out.verdict = PatchVerdict::kFound;
  const cv::Point second = SecondPeak(out.odds, out.best, kOtherPeak * half);
  if (second == out.best) return out;
  out.second = out.scores.at<float>(second);
  const bool two = out.odds.at<float>(out.best) - out.odds.at<float>(second) < settings.least_odds;
  if (two) out.verdict = PatchVerdict::kAmbiguous;
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
                     double sigma_px, double window_px, const FacePatchSettings& settings) {
  const Eigen::Vector3d p_N = X_NC * patch.p_C;
  if (p_N.z() <= 0.0) return {};
  const Eigen::Vector2d at = patch.centre_px + patch.focal_px * p_N.head<2>() / p_N.z();
  const Window window{
      {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))},
      sigma_px,
      window_px};
  const int half =
      std::clamp(static_cast<int>(std::lround(patch.focal_px * settings.half_m / p_N.z())),
                 settings.least_half_px, settings.most_half_px);
  Compared compared = Compare(patch, image, X_NC, window, half, settings);
  if (compared.verdict == PatchVerdict::kAmbiguous) {
    // Near by, stains on either side of a shadow's edge tell; far away noise hides them so.
    Compared local = Compare(patch, image, X_NC, window, half, settings, Greys::kLocal);
    if (local.verdict == PatchVerdict::kFound) compared = std::move(local);
  }
  if (compared.verdict == PatchVerdict::kAmbiguous) {
    Decide(Compare(patch, image, X_NC, window, 2 * half, settings), half, compared);
  }
  PatchFound found{.verdict = compared.verdict, .score = compared.score, .second = compared.second};
  if (found.verdict != PatchVerdict::kFound) return found;
  const cv::Point& best = compared.best;
  // From the patch's middle pixel to the point, and from the window's corner.
  const Eigen::Vector2d to_point = at - window.middle.cast<double>();
  const Eigen::Vector2d first = compared.first.cast<double>();
  const Eigen::Vector2d corner = first - Eigen::Vector2d::Constant(compared.then.cols / 2);
  const Eigen::Vector2d middle = first + Eigen::Vector2d(best.x, best.y);
  const auto fit_by = [&](const Eigen::Vector2d& edge_px) {
    return FitPatch(compared.then, compared.face, compared.about, middle - corner,
                    {.edge_px = edge_px});
  };
  auto fit = fit_by(BendAtEdge(patch, X_NC, compared.then.cols / 2));
  if (!fit) fit = fit_by({0.0, 0.0});
  if (fit) {
    found.pixel = corner + fit->t + fit->A * to_point;
    return found;
  }
  const auto score = [&](int x, int y) {
    return static_cast<double>(compared.scores.at<float>(y, x));
  };
  const double centre = score(best.x, best.y);
  const double du = Vertex(score(best.x - 1, best.y), centre, score(best.x + 1, best.y));
  const double dv = Vertex(score(best.x, best.y - 1), centre, score(best.x, best.y + 1));
  found.pixel = middle + Eigen::Vector2d(du, dv) + to_point;
  return found;
}

}  // namespace dockyard
