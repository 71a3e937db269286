// Impulses of contacts that give way like a spring with a damper and rub by Coulomb's law.
#pragma once

#include <Eigen/Core>
#include <array>

namespace dockyard {

inline constexpr int kMostContacts = 24;

/// Projected Gauss-Seidel ends after this number of sweeps, or once no impulse changes by more than
/// this share of the largest.
inline constexpr int kMostSweeps = 500;
inline constexpr double kSolved = 1e-7;

/// One contact. Rows of it below: along its normal, along the two directions across it.
struct ContactLaw {
  double gap_m = 0.0;  // < 0: pressed in
  double friction = 0.0;
  double stiffness_n_per_m = 0.0;
  double damping_ns_per_m = 0.0;
  // How far the surfaces are bent across while they stick [m]; the step advances it.
  Eigen::Vector2d bend_m{0.0, 0.0};
};

/// At most kMost contacts of one step. `answer` is the velocity of each row for a unit impulse on
/// another [1/kg]; `velocity` that without contacts, apart positive [m/s]; `impulse` [N s] goes in
/// as a first guess and comes out solved.
template <int kMost>
struct ContactStepOf {
  static constexpr int kMostRows = 3 * kMost;
  using Matrix =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostRows, kMostRows>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows, 1>;

  int count = 0;
  std::array<ContactLaw, kMost> laws;
  Matrix answer;
  Vector velocity, impulse;
};
using ContactStep = ContactStepOf<kMostContacts>;

/// The spring and the damper act at the step's end: with gap g, stiffness k, damping c and step h
/// the normal impulse is h max(0, -k (g + h v) - c v), v the velocity after the step. A gap that is
/// still open may close within the step and no further. Across it the same spring and damper act on
/// the bend, up to friction x normal impulse: a contact gives way across about as much as along its
/// normal (Mindlin 1949). Projected Gauss-Seidel until no impulse changes by more than 1e-7 of the
/// largest; returns the number of sweeps, at most 500.
template <int kMost>
int SolveContacts(double step_s, ContactStepOf<kMost>& contacts);

/// For a hand of plates about a body of many corners.
inline constexpr int kManyContacts = 40;
extern template int SolveContacts(double step_s, ContactStepOf<kMostContacts>& contacts);
extern template int SolveContacts(double step_s, ContactStepOf<kManyContacts>& contacts);

}  // namespace dockyard
