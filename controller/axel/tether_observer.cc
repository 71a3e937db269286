#include "controller/axel/tether_observer.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {
TetherCount TetherCountOf(const Senses& senses, double arm_m) {
  const double ahead_m = arm_m * std::cos(senses.elevation_rad());
  const Pose2& X_OR = senses.by_wheels();
  return {senses.reeled_m(), X_OR * Eigen::Vector2d(ahead_m, 0.0), X_OR};
}

double TakenBeyond(const TetherCount& since, const TetherCount& now) {
  return now.reeled_m - since.reeled_m - (now.p_OT - since.p_OT).norm();
}

void SlideWatch::Begin(const Senses& senses) {
  stage_ = TetherCountOf(senses, arm_m_);
  begun_m_ = stage_.reeled_m;
  beyond_m_ = 0.0;
  taut_ = false;
}

void SlideWatch::Stalled(const Senses& senses) {
  if (!taut_) Begin(senses);
  taut_ = true;
}

void SlideWatch::NextStage(const Senses& senses) {
  const TetherCount now = TetherCountOf(senses, arm_m_);
  beyond_m_ += std::max(0.0, TakenBeyond(stage_, now));
  stage_ = now;
}

bool SlideWatch::Slides(const Senses& senses) const {
  const double beyond_m = beyond_m_ + TakenBeyond(stage_, TetherCountOf(senses, arm_m_));
  const double taken_m = std::max(0.0, senses.reeled_m() - begun_m_);
  const double allowed_m = taut_ ? options_.beyond_m : options_.beyond_at_first_m;
  return beyond_m > allowed_m + options_.share * taken_m;
}

double GrowthByWheels(const TetherGeometry& geometry, const Pose2& X_DR_since,
                      const TetherCount& since, const TetherCount& now, double elevation_rad) {
  const Pose2 X_DR = X_DR_since * (Inverse(since.X_OR) * now.X_OR);
  return ExposedTether(geometry, X_DR, elevation_rad) -
         ExposedTether(geometry, X_DR_since, elevation_rad);
}

bool DigWatch::Digs(const Senses& senses) {
  const TetherCount now = TetherCountOf(senses, geometry_.arm_m);
  if (!begin_) begin_ = Begin{now, senses.pose()};
  const double growth_m =
      GrowthByWheels(geometry_, begin_->X_DR, begin_->count, now, senses.elevation_rad());
  if (std::abs(growth_m) < options_.rolled_m) return false;
  const double share = (begin_->count.reeled_m - now.reeled_m) / growth_m;
  begin_ = Begin{now, senses.pose()};
  return share < options_.least_share;
}

}  // namespace dockyard::axel
