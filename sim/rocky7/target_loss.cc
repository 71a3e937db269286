#include "sim/rocky7/target_loss.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// Greys that differ by less are one colour to a matcher of blocks: the noise of a pixel is 1 to 2 %
// of its value. Assumed, 2-10 %.
constexpr double kSameAlbedo = 0.05;

double BeyondWindow(const Eigen::Vector2d& p_E, const Eigen::Vector2d& middle_E, double half_m) {
  const Eigen::Vector2d beyond = ((p_E - middle_E).cwiseAbs().array() - half_m).cwiseMax(0.0);
  return beyond.norm();
}

double FromOutline(const Eigen::Vector2d& p_E, const PlanDisc& disc) {
  return std::max(0.0, (p_E - disc.p_E).norm() - disc.radius_m);
}

// A stone that reaches into the window is nearer to the detection than the target is.
bool AnotherStone(const LossTruth& truth) {
  if (!truth.detected_E) return false;
  const double own_m = FromOutline(*truth.detected_E, {truth.p_ET, truth.target_radius_m});
  const Eigen::Vector2d middle_E = truth.predicted_E.value_or(truth.p_ET);
  return std::any_of(truth.others_E.begin(), truth.others_E.end(), [&](const PlanDisc& other) {
    return BeyondWindow(other.p_E, middle_E, truth.window_m) <= other.radius_m &&
           FromOutline(*truth.detected_E, other) < own_m;
  });
}

}  // namespace

Loss CauseOf(const LossTruth& truth) {
  if (!truth.in_view) return Loss::kFieldOfView;
  if (truth.predicted_E && BeyondWindow(truth.p_ET, *truth.predicted_E, truth.window_m) > 0.0) {
    return Loss::kOdometry;
  }
  if (truth.on_boulder || AnotherStone(truth)) return Loss::kSeveralTargets;
  if (std::abs(truth.albedo_share - 1.0) < kSameAlbedo) return Loss::kColour;
  return Loss::kNoRange;
}

void LossRecord::Lost(Loss cause) {
  if (loss_ == Loss::kNone) loss_ = cause;
  any_ = true;
}

}  // namespace dockyard::rocky7
