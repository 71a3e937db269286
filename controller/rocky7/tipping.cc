#include "controller/rocky7/tipping.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d CentreOfMass(const Nominal& nominal, const std::array<double, 2>& arm,
                      const MastAngles& mast) {
  const NominalMasses& m = nominal.masses;
  const Vector3d p_arm =
      nominal.arm.p_RA + RotX(arm[0]) * RotY(arm[1]) * Vector3d(m.arm_middle_m, 0.0, 0.0);
  const Pose3 X_RK = SecondLink(nominal.mast, mast);
  const Vector3d p_link1 = 0.5 * (nominal.mast.p_RM + X_RK.p);
  const Vector3d p_link2 = X_RK * Vector3d(m.link2_middle_m, 0.0, 0.0);
  const Vector3d moment =
      m.rover_kg * m.p_RC + m.arm_kg * p_arm + m.link1_kg * p_link1 + m.link2_kg * p_link2;
  return moment / (m.rover_kg + m.arm_kg + m.link1_kg + m.link2_kg);
}

// From the sides of the convex hull of places, inwards: a side has all others to its left.
double WithinHull(const std::vector<WheelPlan>& wheels, const Vector2d& p) {
  const auto left_of = [&](std::size_t i, std::size_t j, const Vector2d& q) {
    const Vector2d along = (wheels[j].p_RW - wheels[i].p_RW).normalized();
    const Vector2d to = q - wheels[i].p_RW;
    return along.x() * to.y() - along.y() * to.x();
  };
  double least_m = 1e9;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    for (std::size_t j = 0; j < wheels.size(); ++j) {
      if (i == j) continue;
      const bool is_side = std::all_of(wheels.begin(), wheels.end(), [&](const WheelPlan& wheel) {
        return left_of(i, j, wheel.p_RW) > -1e-9;
      });
      if (is_side) least_m = std::min(least_m, left_of(i, j, p));
    }
  }
  return least_m;
}

}  // namespace

double TippingMargin(const Nominal& nominal, const ImuSample& attitude,
                     const std::array<double, 2>& arm, const MastAngles& mast) {
  if (nominal.masses.rover_kg <= 0.0) return std::numeric_limits<double>::infinity();
  const Vector3d p_RC = CentreOfMass(nominal, arm, mast);
  const Eigen::Matrix3d R_ER = RotY(attitude.pitch_rad) * RotX(attitude.roll_rad);
  const Vector3d down_R = -R_ER.transpose() * Vector3d::UnitZ();
  const double share = (-nominal.rolling_radius_m - p_RC.z()) / down_R.z();
  return WithinHull(nominal.plan.wheels, (p_RC + share * down_R).head<2>());
}

}  // namespace dockyard::rocky7
