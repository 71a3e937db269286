#include "controller/motion/path_follower.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr double kArrived_m = 0.004;  // well below the vision's 2.5 cm at 1 m (Tsai et al., V-E)

}  // namespace

PathFollower::PathFollower(const Pose2& X_DR_start, std::vector<Arc> arcs)
    : arcs_(std::move(arcs)) {
  Pose2 pose = X_DR_start;
  for (const Arc& arc : arcs_) {
    starts_.push_back(pose);
    pose = Advance(pose, arc);
  }
}

Pose2 PathFollower::Reference() const {
  if (arcs_.empty()) return {};
  const std::size_t i = std::min(current_, arcs_.size() - 1);
  const double length = std::abs(arcs_[i].length_m);
  const double share = done() || length == 0.0 ? 1.0 : std::min(1.0, progress_m_ / length);
  return Advance(starts_[i], Part(arcs_[i], share));
}

double PathFollower::Remaining() const {
  double left = -progress_m_;
  for (std::size_t i = current_; i < arcs_.size(); ++i) left += std::abs(arcs_[i].length_m);
  return done() ? 0.0 : std::max(0.0, left);
}

Twist PathFollower::Follow(const Pose2& X_DR, double speed_m_s, const Steering& steering,
                           double drift) {
  while (!done()) {
    const Arc& arc = arcs_[current_];
    const double direction = arc.length_m < 0.0 ? -1.0 : 1.0;
    const Pose2 ahead = Inverse(Reference()) * X_DR;
    progress_m_ = std::max(0.0, progress_m_ + direction * ahead.x);
    if (progress_m_ >= std::abs(arc.length_m) - kArrived_m) {
      ++current_;
      progress_m_ = 0.0;
      continue;
    }
    const Pose2 error = Inverse(Reference()) * X_DR;
    const double v = direction * speed_m_s, s = steering.settle_m;
    const double turn = v * arc.turn_rad / arc.length_m -
                        2.0 * std::abs(v) / s * (error.heading + direction * drift) -
                        v / (s * s) * error.y;
    return {v, std::clamp(turn, -steering.max_turn_rad_s, steering.max_turn_rad_s)};
  }
  return {};
}

}  // namespace dockyard
