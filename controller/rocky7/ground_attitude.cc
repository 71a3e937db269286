#include "controller/rocky7/ground_attitude.h"

#include <Eigen/Geometry>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// A mean over this distance: longer than the rover, shorter than a slope. Assumed, 0.5-2 m.
constexpr double kOver_m = 1.0;

Eigen::Rotation2Dd Heading(const ImuSample& attitude) {
  return Eigen::Rotation2Dd(attitude.yaw_rad);
}

}  // namespace

void GroundPlane::Add(const ImuSample& attitude, double driven_m) {
  const Eigen::Vector2d now_W =
      Heading(attitude) * Eigen::Vector2d(attitude.roll_rad, attitude.pitch_rad);
  const double share = begun_ ? 1.0 - std::exp(-std::abs(driven_m) / kOver_m) : 1.0;
  mean_W_ += share * (now_W - mean_W_);
  begun_ = true;
}

ImuSample GroundPlane::Parallel(const ImuSample& now) const {
  const Eigen::Vector2d mean = Heading(now).inverse() * mean_W_;
  ImuSample parallel = now;
  parallel.roll_rad = mean.x();
  parallel.pitch_rad = mean.y();
  return parallel;
}

Eigen::Vector2d GroundPlane::Rise(const ImuSample& now) const {
  const ImuSample parallel = Parallel(now);
  return {-std::tan(parallel.pitch_rad), std::tan(parallel.roll_rad)};
}

}  // namespace dockyard::rocky7
