#include "controller/axel/mouth_way.h"

#include <algorithm>
#include <cmath>

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
  const double left_m = x_m - (geometry.arm_m + mate.enter_gap_m);
  const double learned = geometry.mouth_drift;
  const double here = drift + (left_m < mate.learned_way_m ? learned : 0.0);
  return {x_m, left_m * drift + std::min(left_m, mate.learned_way_m) * learned,
          WrapPi(kPi + std::atan(here))};
}

double TurnForTip(double arm_m, const Pose2& X_DR, double speed_m_s, double drift,
                  const Steering& steering) {
  const double h = WrapPi(X_DR.heading - kPi);
  const double tip_m = X_DR.y - arm_m * std::sin(h);
  const double turn_rad_s = speed_m_s *
                            (tip_m / steering.settle_m - std::sin(h) - drift * std::cos(h)) /
                            (arm_m * std::cos(h));
  return std::clamp(turn_rad_s, -steering.max_turn_rad_s, steering.max_turn_rad_s);
}

Pose2 AfterMouthLine(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                     double drift) {
  // Turns on soil fall short by 15-40 % of what the wheels are told; assumed, 0.6-0.85 are done.
  constexpr double kTurned = 0.7;
  constexpr double kStep_m = 0.005;
  const double end_m = geometry.arm_m + options.mate.enter_gap_m;
  const double speed_m_s = options.drive.mate_m_s, seconds = kStep_m / speed_m_s;
  Pose2 at = X_DR;
  for (int i = 0; i < 2.0 * (X_DR.x - end_m) / kStep_m && at.x > end_m; ++i) {
    const double turn_rad_s =
        TurnForTip(geometry.arm_m, at, speed_m_s, drift, options.drive.fine_steering);
    at = Advance(at, Arc{kStep_m, kTurned * turn_rad_s * seconds}) *
         Pose2{0.0, (drift + geometry.mouth_drift) * kStep_m, 0.0};
  }
  return at;
}

bool CanMate(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
             double drift) {
  const auto aligned = [&](const PlanGeometry& with) {
    return Aligned(with, options.mate, AfterMouthLine(with, options, X_DR, drift));
  };
  PlanGeometry unlearned = geometry;
  unlearned.mouth_drift = 0.0;
  return aligned(geometry) || (geometry.mouth_drift != 0.0 && aligned(unlearned));
}

}  // namespace dockyard::axel
