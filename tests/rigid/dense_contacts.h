// Contacts solved by a dense matrix of what each answers to each: an independent computation for
// tests of the world's solver.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/rigid/contact_law.h"

namespace dockyard {

inline constexpr int kMostContacts = 24;

/// At most kMostContacts contacts of one step. `answer` is the velocity of each row for a unit
/// impulse on another [1/kg]; `velocity` that without contacts, apart positive [m/s]; `impulse` [N
/// s] goes in as a first guess and comes out solved.
struct ContactStep {
  static constexpr int kMostRows = 3 * kMostContacts;
  using Matrix =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostRows, kMostRows>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows, 1>;

  int count = 0;
  std::array<ContactLaw, kMostContacts> laws;
  Matrix answer;
  Vector velocity, impulse;
};

// What one contact's rows need in a sweep.
struct DenseRows {
  double softness = 0.0;  // velocity per normal impulse that the spring yields [1/kg]
  double bias_m_s = 0.0;  // velocity that the gap asks for
  Eigen::Vector2d unbend_m_s{0.0, 0.0};  // velocity that the bend asks for
  double along = 0.0;                    // 1 / (own answer + softness)
  double across = 0.0;  // 1 / (the largest own answer of the two rows across + softness)
};

template <class Matrix>
DenseRows RowsOf(const ContactLaw& law, const Matrix& answer, int row, double h) {
  DenseRows rows;
  const double give = h * law.stiffness_n_per_m + law.damping_ns_per_m;
  rows.softness = 1.0 / (h * give);
  rows.bias_m_s = law.gap_m > 0.0 ? law.gap_m / h : law.stiffness_n_per_m * law.gap_m / give;
  rows.along = 1.0 / (answer(row, row) + rows.softness);
  const double a = answer(row + 1, row + 1), b = answer(row + 2, row + 2);
  rows.unbend_m_s = law.stiffness_n_per_m / give * law.bend_m;
  rows.across =
      1.0 / (0.5 * (a + b) + std::hypot(0.5 * (a - b), answer(row + 1, row + 2)) + rows.softness);
  return rows;
}

// Advances the bends by the velocities after the step.
inline void Bend(double step_s, ContactStep& contacts) {
  for (int i = 0; i < contacts.count; ++i) {
    ContactLaw& law = contacts.laws[i];
    const int row = 3 * i + 1;
    const Eigen::Vector2d sliding =
        contacts.velocity.segment<2>(row) + contacts.answer.middleRows<2>(row) * contacts.impulse;
    law.bend_m += step_s * sliding;
    const double most = law.friction * contacts.impulse[3 * i] / (step_s * law.stiffness_n_per_m);
    const double size = law.bend_m.norm();
    if (size > most) law.bend_m *= most / size;
  }
}

inline int SolveContacts(double step_s, ContactStep& contacts) {
  std::array<DenseRows, kMostContacts> rows;
  for (int i = 0; i < contacts.count; ++i) {
    rows[i] = RowsOf(contacts.laws[i], contacts.answer, 3 * i, step_s);
  }
  auto& impulse = contacts.impulse;
  const auto VelocityOf = [&](int row) {
    return contacts.velocity[row] + contacts.answer.row(row).dot(impulse);
  };
  int sweeps = 0;
  while (sweeps < kMostSweeps) {
    double change = 0.0, largest = 0.0;
    for (int i = 0; i < contacts.count; ++i) {
      const int row = 3 * i;
      const DenseRows& own = rows[i];
      const double before = impulse[row];
      const double wanted =
          before - own.along * (VelocityOf(row) + own.softness * before + own.bias_m_s);
      impulse[row] = std::max(0.0, wanted);
      change = std::max(change, std::abs(impulse[row] - before));
      largest = std::max(largest, impulse[row]);

      const Eigen::Vector2d rubbed = impulse.segment<2>(row + 1);
      const Eigen::Vector2d sliding(VelocityOf(row + 1), VelocityOf(row + 2));
      Eigen::Vector2d rub =
          rubbed - own.across * (sliding + own.softness * rubbed + own.unbend_m_s);
      const double most = contacts.laws[i].friction * impulse[row], size = rub.norm();
      if (size > most) rub *= most / size;
      impulse.segment<2>(row + 1) = rub;
      change = std::max(change, (rub - rubbed).lpNorm<Eigen::Infinity>());
    }
    ++sweeps;
    if (change <= kSolved * largest) break;
  }
  Bend(step_s, contacts);
  return sweeps;
}

}  // namespace dockyard
