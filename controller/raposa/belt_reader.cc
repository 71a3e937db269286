#include "controller/raposa/belt_reader.h"

#include <cmath>

#include "controller/raposa/odometry.h"

namespace dockyard::raposa {

double BeltReader::gauge_m() const {
  const bool pressed = arm_rad_ > options_.leaning_rad;
  return nominal_.effective_gauge_m * (pressed ? options_.pressed_gauge_share : 1.0);
}

std::optional<BeltSteps> BeltReader::Read(const SensorFrame& sensed, bool driven) {
  const double arm_before_rad = arm_rad_;
  arm_rad_ = MotorAngle(nominal_, sensed, Motor::kArm);
  const std::array<double, 2> before_m = belts_m_.value_or(std::array<double, 2>{});
  const bool first = !belts_m_;
  belts_m_ = {nominal_.sprocket_radius_m * MotorAngle(nominal_, sensed, Motor::kLeftBelt),
              nominal_.sprocket_radius_m * MotorAngle(nominal_, sensed, Motor::kRightBelt)};
  if (first) return std::nullopt;
  return BeltSteps{.left_m = (*belts_m_)[0] - before_m[0],
                   .right_m = (*belts_m_)[1] - before_m[1],
                   .driven = driven,
                   .gauge_m = gauge_m(),
                   .arm_m = nominal_.sprocket_radius_m * std::abs(arm_rad_ - arm_before_rad),
                   .dt_s = kTickSeconds * kControlPeriod};
}

}  // namespace dockyard::raposa
