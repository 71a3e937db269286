#include "controller/rocky7/detour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector2d;

// From here on a slope is steep: in loose sand the wheels slip by half. Assumed, 4-8 deg.
constexpr double kSteep_rad = 0.1;
// The target is up the slope within 45 deg.
constexpr double kUphill = 0.7;
// It ends so near to its place. Assumed, 0.1-0.2 m.
constexpr double kThere_m = 0.15;
// Progress below this is none (assumed, 1-4 cm); the most pairs in a row without any (assumed,
// 3-6).
constexpr double kDetourNearer_m = 0.02;
constexpr int kMostDetourStalls = 4;

// Up the slope, in R's plan: its length is the sine of the slope.
Vector2d Uphill(const ImuSample& attitude) {
  return {-std::sin(attitude.pitch_rad), std::sin(attitude.roll_rad)};
}

}  // namespace

void Detour::Begin(const Vector2d& p_PT_R, const ImuSample& attitude) {
  const Vector2d up = Uphill(attitude);
  const double left_m = p_PT_R.norm();
  if (up.norm() < std::sin(kSteep_rad)) return;
  if (up.normalized().dot(p_PT_R) < kUphill * left_m) return;
  side_ = -side_;
  const Vector2d ahead = up.normalized(), left(-ahead.y(), ahead.x());
  p_TD_ = Eigen::Rotation2Dd(attitude.yaw_rad) * (0.5 * left_m * (side_ * left - ahead));
  nearest_m_ = 1e9;
  stalls_ = 0;
}

std::optional<Vector2d> Detour::FromTarget(double yaw_rad) const {
  if (!p_TD_) return std::nullopt;
  return Eigen::Rotation2Dd(-yaw_rad) * *p_TD_;
}

void Detour::Update(const Vector2d& p_PT_R, double yaw_rad) {
  const auto p_TD_R = FromTarget(yaw_rad);
  if (!p_TD_R) return;
  const double off_m = (p_PT_R + *p_TD_R).norm();
  stalls_ = off_m < nearest_m_ - kDetourNearer_m ? 0 : stalls_ + 1;
  nearest_m_ = std::min(nearest_m_, off_m);
  if (off_m < kThere_m || stalls_ >= kMostDetourStalls) p_TD_.reset();
}

}  // namespace dockyard::rocky7
