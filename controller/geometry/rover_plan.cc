#include "controller/geometry/rover_plan.h"

namespace dockyard {

std::optional<double> TurningLine_m(const std::vector<WheelPlan>& wheels) {
  double sum = 0.0;
  int fixed = 0;
  for (const WheelPlan& wheel : wheels) {
    if (wheel.steer_limit_rad != 0.0) continue;
    sum += wheel.p_RW.x();
    ++fixed;
  }
  if (fixed == 0) return std::nullopt;
  return sum / fixed;
}

}  // namespace dockyard
