// A stone that nothing holds: a rigid convex body that flies freely between contacts.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sim/rigid/convex_body.h"
#include "sim/rigid/motion.h"
#include "sim/rigid/solid_mass.h"

namespace dockyard {

/// Basalt and its like; assumed, 2 500-3 000 kg/m^3.
inline constexpr double kStoneDensity_kg_m3 = 2700.0;

/// The hull of points on an ellipsoid with axes 1 : 0.8 : 0.65 along x, y, z and noise along their
/// radius, scaled to this length along x. Centred on its centre of mass. Same key, same shape.
ConvexBody LooseStoneShape(double length_m, std::uint64_t key);

/// The pose in which a shape stands on level ground at this height, its lowest corner on it.
Pose3 StandingAt(const ConvexBody& shape, const Eigen::Vector2d& p_G, double turn_rad,
                 double ground_m);

/// Frame S: the centre of mass of the stone, axes of its shape.
class LooseStone {
 public:
  /// Moves the shape so that its centre of mass is S. X_GS: where it starts, at rest.
  LooseStone(const ConvexBody& shape, double density_kg_m3, const Pose3& X_GS);

  const ConvexBody& shape_S() const { return shape_S_; }
  double mass_kg() const { return mass_kg_; }
  const LinkMotion& motion() const { return motion_; }
  /// About the centre of mass, in G [kg m^2 / s].
  const Eigen::Vector3d& angular_momentum_G() const { return spin_G_; }
  double KineticEnergy() const;
  /// Inverse of the inertia in G [1 / (kg m^2)].
  Eigen::Matrix3d InverseInertia() const;

  void SetMotion(const Eigen::Vector3d& v_G, const Eigen::Vector3d& w_G);
  /// An impulse on the point p_G [N s].
  void AddImpulse(const Eigen::Vector3d& impulse_G, const Eigen::Vector3d& p_G);
  /// Weight for a step.
  void TakeWeight(const Eigen::Vector3d& gravity_G, double step_s);
  /// A step's flight. Angular momentum stays as it is to rounding; the turning is of second order.
  void Move(double step_s);
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  ConvexBody shape_S_;
  double mass_kg_ = 0.0;
  Eigen::Matrix3d inertia_S_, inverse_S_;
  LinkMotion motion_;
  Eigen::Vector3d spin_G_ = Eigen::Vector3d::Zero();
};

}  // namespace dockyard
