// How a contact gives way like a spring with a damper, and rubs by Coulomb's law.
#pragma once

#include <Eigen/Core>

namespace dockyard {

/// One contact. The spring and the damper act at the step's end: with gap g, stiffness k, damping c
/// and step h the normal impulse is h max(0, -k (g + h v) - c v), v the velocity after the step. A
/// gap that is still open may close within the step and no further. Across it the same spring and
/// damper act on the bend, up to friction x normal impulse: a contact gives way across about as
/// much as along its normal (Mindlin 1949).
struct ContactLaw {
  double gap_m = 0.0;  // < 0: pressed in
  double friction = 0.0;
  double stiffness_n_per_m = 0.0;
  double damping_ns_per_m = 0.0;
  // How far the surfaces are bent across while they stick [m]; the step advances it.
  Eigen::Vector2d bend_m{0.0, 0.0};
  // The share of that bend that is left when the step begins: below 1 where a tyre rolls and its
  // bent part leaves the ground. The damper acts on all change of the bend.
  double bend_kept = 1.0;
};

/// Projected Gauss-Seidel ends after this number of sweeps, or once no impulse changes by more than
/// this share of the largest.
inline constexpr int kMostSweeps = 500;
inline constexpr double kSolved = 1e-7;

}  // namespace dockyard
