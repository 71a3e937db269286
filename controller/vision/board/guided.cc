#include "controller/vision/board/guided.h"

#include <algorithm>
#include <cmath>

#include "controller/vision/board/bar.h"
#include "controller/vision/board/rim.h"

namespace dockyard {
namespace {

// Against 0.70 in the whole image: one place of known size and rotation is tried, not thousands.
constexpr double kMinWhole = 0.55;
constexpr double kMinWholePlain = 0.75;  // against 0.85; no bar's direction is there to be checked
constexpr double kMinContrast = 0.20;
constexpr double kSizeTolerance = 1.15;  // either way; a pose knows sizes to a few per cent
// How much worse than the best direction the known one may match.
constexpr float kBarSlack = 0.12f;
constexpr double kMaxLevelRadius = 9.0;  // the closing of a level fills discs up to about 19 px
constexpr double kFineBlur = 0.97, kCoarseBlur = 0.80;  // as in fiducials.cc

}  // namespace

std::optional<Ellipse> ExpectedRim(const Camera& camera, const Pose3& X_CB,
                                   const Fiducial& fiducial, double diameter_m) {
  constexpr int kPoints = 24;
  std::vector<Eigen::Vector2d> rim;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * kPi * i / kPoints;
    const Eigen::Vector2d p_B =
        fiducial.p_BF + 0.5 * diameter_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const auto pixel = camera.Project(X_CB * Eigen::Vector3d(p_B.x(), p_B.y(), 0.0));
    if (!pixel || !camera.Sees(*pixel, 1.0)) return std::nullopt;
    rim.push_back(*pixel);
  }
  return FitEllipse(rim);
}

double ExpectedBar(const Camera& camera, const Pose3& X_CB, const Fiducial& fiducial,
                   double length_m, const Ellipse& rim) {
  const Eigen::Vector2d along(std::cos(fiducial.rotation), -std::sin(fiducial.rotation));
  const auto end = [&](double sign) {
    const Eigen::Vector2d p_B = fiducial.p_BF + 0.5 * sign * length_m * along;
    return camera.Project(X_CB * Eigen::Vector3d(p_B.x(), p_B.y(), 0.0));
  };
  const auto a = end(-1.0), b = end(1.0);
  if (!a || !b) return fiducial.rotation;
  const Eigen::Vector2d direction = rim.shape_px.inverse() * (*b - *a);
  return std::atan2(-direction.y(), direction.x());
}

std::optional<DetectedFiducial> DetectAt(const GrayImage& image,
                                         const std::vector<BlobLevel>& levels,
                                         const Ellipse& expected, double bar_direction_rad,
                                         const FiducialBoard& board, double gate_px) {
  const auto rim = RefineRim(image, expected);
  if (!rim) return std::nullopt;
  const double radius = rim->ellipse.mean_radius_px(), wanted = expected.mean_radius_px();
  if ((rim->ellipse.centre_px - expected.centre_px).norm() > gate_px ||
      radius > kSizeTolerance * wanted || wanted > kSizeTolerance * radius) {
    return std::nullopt;
  }
  std::size_t at = 0;
  while (at + 1 < levels.size() && radius / levels[at].scale() > kMaxLevelRadius) ++at;
  const BlobLevel& level = levels[at];
  const Ellipse there{.centre_px = level.FromImage(rim->ellipse.centre_px),
                      .shape_px = rim->ellipse.shape_px / level.scale()};
  const auto bar =
      MatchBar(level.flat, there, board, level.level == 0 ? kFineBlur : kCoarseBlur, 1.0);
  const double least = board.HasBars() ? kMinWhole : kMinWholePlain;
  if (!bar || bar->whole < least || bar->contrast < kMinContrast) return std::nullopt;
  const double turns = bar_direction_rad / kPi * kBarAngles;
  const int index = ((static_cast<int>(std::lround(turns)) % kBarAngles) + kBarAngles) % kBarAngles;
  const float best = *std::max_element(bar->inner.begin(), bar->inner.end());
  const bool shows = best > 0.3f;  // a small disc hardly shows its bar
  if (shows && bar->inner[static_cast<std::size_t>(index)] < best - kBarSlack) return std::nullopt;
  DetectedFiducial found{
      .rim = rim->ellipse, .match = bar->whole, .bar_match = bar->inner, .clear = shows};
  SettleCentre(image, board, &found);
  return found;
}

}  // namespace dockyard
