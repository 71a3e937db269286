#include "controller/raposa/way_control.h"

#include <algorithm>
#include <cmath>

namespace dockyard::raposa {

Twist TurnBy(double left_rad, const FerreiraMotion& options) {
  return {0.0,
          std::clamp(options.turn_gain_per_s * left_rad, -options.turn_rad_s, options.turn_rad_s)};
}

bool Turned(double left_rad, const FerreiraMotion& options) {
  return std::abs(left_rad) <= options.turn_tolerance_rad;
}

Twist DriveTo(const AlignPlan& plan, const Pose2& X_ON, const FerreiraMotion& options) {
  const double lead_m = plan.way_m < 0.0 ? -options.lead_m : options.lead_m;
  const Eigen::Vector2d lead(lead_m, 0.0);
  const Eigen::Vector2d error = Pose2{plan.X_OE.x, plan.X_OE.y, plan.beta_rad} * lead - X_ON * lead;
  const Eigen::Vector2d error_N = Inverse(Pose2{0.0, 0.0, X_ON.heading}) * error;
  const Twist wanted{options.way_gain_per_s * error_N.x(),
                     options.way_gain_per_s * error_N.y() / lead_m};
  const double over = std::max({1.0, std::abs(wanted.speed_m_s) / options.travel_m_s,
                                std::abs(wanted.turn_rad_s) / options.turn_rad_s});
  return {wanted.speed_m_s / over, wanted.turn_rad_s / over};
}

double WayLeft(const AlignPlan& plan, const Pose2& X_ON) {
  const double sign = plan.way_m < 0.0 ? -1.0 : 1.0;
  return sign * ((plan.X_OE.x - X_ON.x) * std::cos(plan.beta_rad) +
                 (plan.X_OE.y - X_ON.y) * std::sin(plan.beta_rad));
}

bool Arrived(const AlignPlan& plan, const Pose2& X_ON, const FerreiraMotion& options) {
  return WayLeft(plan, X_ON) <= options.way_tolerance_m;
}

}  // namespace dockyard::raposa
