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

Pose2 CameraInPlan(const Nominal& nominal) {
  const Eigen::Vector3d view_R = nominal.X_RC.R.col(2);
  return {-nominal.X_RC.p.x(), -nominal.X_RC.p.y(), std::atan2(-view_R.y(), -view_R.x())};
}

double CameraPitch(const Nominal& nominal) {
  const Eigen::Vector3d view_R = nominal.X_RC.R.col(2);
  return std::atan2(-view_R.z(), std::hypot(view_R.x(), view_R.y()));
}

}  // namespace dockyard::raposa
