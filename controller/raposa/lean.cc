#include "controller/raposa/lean.h"

#include <cmath>

namespace dockyard::raposa {

double LeanOf(const Nominal& nominal, double arm_rad) {
  if (arm_rad <= 0.0) return 0.0;
  return std::atan2(nominal.arm_length_m * std::sin(arm_rad),
                    nominal.body_belt_m + nominal.arm_length_m * std::cos(arm_rad));
}

double SeatBehind(const Nominal& nominal, double lean_rad) {
  return -(nominal.p_RS.x() * std::cos(lean_rad) - nominal.p_RS.z() * std::sin(lean_rad));
}

}  // namespace dockyard::raposa
