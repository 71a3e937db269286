#include "controller/axel/mouth_way.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/path_follower.h"

namespace dockyard::axel {

double SocketAngle(const PlanGeometry& geometry, double axle_offset_m) {
  const double sine = std::clamp(axle_offset_m / geometry.arm_m, -1.0, 1.0);
  return std::asin(sine) * std::exp(-geometry.mating_depth_m / geometry.arm_m);
}

bool Aligned(const PlanGeometry& geometry, const MateOptions& mate, const Pose2& X_DR) {
  const double h = WrapPi(X_DR.heading - kPi);
  if (std::abs(h) > mate.heading_rad) return false;
  const double to_mouth = std::max(0.0, X_DR.x - geometry.arm_m);
  const double axle_then = X_DR.y - to_mouth * std::tan(h);
  const double tip_then = axle_then - geometry.arm_m * std::sin(h);
  return std::abs(tip_then) <= mate.tip_offset_m &&
         std::abs(SocketAngle(geometry, axle_then)) <= mate.socket_rad;
}

Pose2 MouthLineAt(const PlanGeometry& geometry, const MateOptions& mate, double x_m, double drift) {
  const double course = std::atan(drift);
  const double left_m = x_m - (geometry.arm_m + mate.enter_gap_m);
  return {x_m, left_m * std::tan(course), WrapPi(kPi + course)};
}

Pose2 AfterMouthLine(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                     double drift) {
  // Turns on soil fall short by 15-40 % of what the wheels are told; assumed, 0.6-0.85 are done.
  constexpr double kTurned = 0.7;
  constexpr double kStep_m = 0.005;
  const Pose2 start = MouthLineAt(geometry, options.mate, X_DR.x, drift);
  const double way_m = X_DR.x - (geometry.arm_m + options.mate.enter_gap_m);
  Pose2 at = X_DR;
  if (way_m <= 0.0) return at;
  PathFollower follower(start, {{way_m / std::cos(std::atan(drift)), 0.0}});
  const double speed_m_s = options.drive.mate_m_s, seconds = kStep_m / speed_m_s;
  for (int i = 0; i < 2.0 * way_m / kStep_m; ++i) {
    const Twist twist = follower.Follow(at, speed_m_s, options.drive.fine_steering, drift);
    if (follower.done()) break;
    at = Advance(at, Arc{kStep_m, kTurned * twist.turn_rad_s * seconds}) *
         Pose2{0.0, drift * kStep_m, 0.0};
  }
  return at;
}

bool CanMate(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
             double drift) {
  return Aligned(geometry, options.mate, AfterMouthLine(geometry, options, X_DR, drift));
}

}  // namespace dockyard::axel
