#include "sim/rigid/constraint_system.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "controller/base/check.h"
#include "sim/rigid/four_doubles.h"

namespace dockyard {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Of an island before it is solved along conjugate directions. Numerical: most end sooner.
constexpr int kPlainSweeps = 10;

// The largest eigenvalue of a symmetric matrix of two rows.
double Largest(double a, double b, double off) {
  return 0.5 * (a + b) + std::hypot(0.5 * (a - b), off);
}

}  // namespace

bool ConstraintSystem::Sweep::IsLast(double solved) const {
  return force <= solved * largest_force && torque <= solved * largest_torque;
}

void ConstraintSystem::Start(Index speeds, double step_s, double solved) {
  step_s_ = step_s;
  solved_ = solved;
  speeds_.setZero(speeds);
  joined_.resize(static_cast<std::size_t>(speeds));
  std::iota(joined_.begin(), joined_.end(), 0);
  numbers_.clear();
  terms_.clear();
  contacts_.clear();
  rollings_.clear();
  ties_.clear();
  joints_.clear();
}

DOCKYARD_TWO_WIDTHS
ConstraintSystem::Rows ConstraintSystem::AddRows(const Vector3d& impulse,
                                                 const ConstraintEnds& ends) {
  Rows rows;
  rows.numbers = numbers_.size();
  rows.terms = terms_.size();
  rows.impulse = impulse;
  FourDoubles own[3] = {};  // columns
  for (std::size_t e = 0; e < 2; ++e) {
    const ConstraintEnd& end = ends[e];
    rows.first[e] = end.first;
    rows.places[e] = end.places;
    if (end.places == 0) continue;
    const double* const answer = end.answer.data();
    numbers_.insert(numbers_.end(), answer, answer + 3 * end.places);
    for (const int i : end.moved) {
      const double* const jacobian = end.jacobian.data() + 4 * i;
      if (jacobian[0] == 0.0 && jacobian[1] == 0.0 && jacobian[2] == 0.0) continue;
      terms_.push_back({end.first + i, jacobian[0], jacobian[1], jacobian[2]});
      FourDoubles to;
      Load(jacobian, to);
      for (int k = 0; k < 3; ++k) own[k] += to * answer[k * end.places + i];
    }
  }
  for (int k = 0; k < 3; ++k) rows.own.col(k) = Vector3d(own[k][0], own[k][1], own[k][2]);
  rows.term_count = terms_.size() - rows.terms;
  if (rows.places[0] > 0 && rows.places[1] > 0) {
    const Index a = LowestOf(rows.first[0]), b = LowestOf(rows.first[1]);
    joined_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  return rows;
}

void ConstraintSystem::AddContact(const ContactLaw& law, const Vector3d& impulse,
                                  const ConstraintEnds& ends) {
  DOCKYARD_CHECK(law.stiffness_n_per_m > 0.0);
  Contact contact;
  contact.rows = AddRows(impulse, ends);
  contact.law = law;
  const Matrix3d& own = contact.rows.own;
  const double give = step_s_ * law.stiffness_n_per_m + law.damping_ns_per_m;
  contact.softness = 1.0 / (step_s_ * give);
  contact.bias_m_s =
      law.gap_m > 0.0 ? law.gap_m / step_s_ : law.stiffness_n_per_m * law.gap_m / give;
  contact.along = 1.0 / (own(0, 0) + contact.softness);
  const Vector2d left_m = law.bend_kept * law.bend_m;
  contact.unbend_m_s = law.stiffness_n_per_m / give * left_m;
  if (law.bend_kept != 1.0) {
    contact.unbend_m_s += law.damping_ns_per_m / (step_s_ * give) * (left_m - law.bend_m);
    contact.law.bend_m = left_m;
  }
  contact.across = 1.0 / (Largest(own(1, 1), own(2, 2), own(1, 2)) + contact.softness);
  contacts_.push_back(contact);
}

void ConstraintSystem::AddRolling(double resistance_m, const Vector3d& impulse,
                                  const ConstraintEnds& ends, std::size_t contacts) {
  DOCKYARD_CHECK(contacts > 0 && contacts <= contacts_.size());
  Rolling rolling;
  rolling.rows = AddRows(impulse, ends);
  rolling.contact = contacts_.size() - contacts;
  rolling.end = contacts_.size();
  rolling.resistance_m = resistance_m;
  const Matrix3d& own = rolling.rows.own;
  const double largest = Largest(own(0, 0), own(1, 1), own(0, 1));
  rolling.across = largest > 0.0 ? 1.0 / largest : 0.0;
  rollings_.push_back(rolling);
}

void ConstraintSystem::AddTie(double stiffness_n_per_m, double damping_ns_per_m,
                              const Vector3d& gap_m, const Vector3d& impulse,
                              const ConstraintEnds& ends) {
  DOCKYARD_CHECK(stiffness_n_per_m > 0.0);
  Tie tie;
  tie.rows = AddRows(impulse, ends);
  const double give = step_s_ * stiffness_n_per_m + damping_ns_per_m;
  tie.softness = 1.0 / (step_s_ * give);
  tie.bias_m_s = stiffness_n_per_m / give * gap_m;
  tie.inverse = (tie.rows.own + tie.softness * Matrix3d::Identity()).inverse();
  ties_.push_back(tie);
}

void ConstraintSystem::AddJoint(const JointRow& row, const TreeBody::Speeds& answer) {
  Joint joint{.row = row, .count = answer.size(), .numbers = numbers_.size()};
  for (Index i = 0; i < answer.size(); ++i) numbers_.push_back(answer[i]);
  joint.own = answer[row.speed - row.first];
  if (row.other >= 0) joint.own -= answer[row.other - row.first];
  joints_.push_back(joint);
}

Vector3d ConstraintSystem::VelocityOf(const Rows& rows) const {
  double x = 0.0, y = 0.0, z = 0.0;
  const double* const speeds = speeds_.data();
  const Term* const end = terms_.data() + rows.terms + rows.term_count;
  for (const Term* term = terms_.data() + rows.terms; term != end; ++term) {
    const double speed = speeds[term->speed];
    x += term->x * speed;
    y += term->y * speed;
    z += term->z * speed;
  }
  return {x, y, z};
}

void ConstraintSystem::Push(const Rows& rows, const Vector3d& more) {
  const double* x = numbers_.data() + rows.numbers;
  const double a = more[0], b = more[1], c = more[2];
  for (std::size_t e = 0; e < 2; ++e) {
    const Index places = rows.places[e];
    if (places == 0) continue;
    const double *y = x + places, *z = y + places;
    double* const speed = speeds_.data() + rows.first[e];
    for (Index i = 0; i < places; i += 4) {
      FourDoubles in_x, in_y, in_z, at;
      Load(x + i, in_x);
      Load(y + i, in_y);
      Load(z + i, in_z);
      Load(speed + i, at);
      at += in_x * a + in_y * b + in_z * c;
      Store(at, speed + i);
    }
    x = z + places;
  }
}

void ConstraintSystem::PushJoint(Joint& joint, double more) {
  const double* number = numbers_.data() + joint.numbers;
  double* speed = speeds_.data() + joint.row.first;
  for (Index i = 0; i < joint.count; ++i) speed[i] += joint.row.sign * more * number[i];
}

void ConstraintSystem::PushFirstGuesses() {
  for (Tie& tie : ties_) Push(tie.rows, tie.rows.impulse);
  for (Joint& joint : joints_) PushJoint(joint, joint.row.impulse);
  for (Contact& contact : contacts_) Push(contact.rows, contact.rows.impulse);
  for (Rolling& rolling : rollings_) Push(rolling.rows, rolling.rows.impulse);
}

Index ConstraintSystem::LowestOf(Index first) const {
  while (joined_[static_cast<std::size_t>(first)] != first) {
    first = joined_[static_cast<std::size_t>(first)];
  }
  return first;
}

ConstraintSystem::Island& ConstraintSystem::IslandOf(Index first) {
  int& number = island_of_[static_cast<std::size_t>(LowestOf(first))];
  if (number < 0) {
    number = island_count_++;
    if (static_cast<std::size_t>(number) == islands_.size()) islands_.emplace_back();
    Island& island = islands_[static_cast<std::size_t>(number)];
    for (auto* part : {&island.ties, &island.joints, &island.contacts, &island.rollings}) {
      part->clear();
    }
  }
  return islands_[static_cast<std::size_t>(number)];
}

void ConstraintSystem::FindIslands() {
  island_count_ = 0;
  island_of_.assign(joined_.size(), -1);
  for (std::size_t i = 0; i < ties_.size(); ++i) IslandOf(ties_[i].rows).ties.push_back(i);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    IslandOf(joints_[i].row.first).joints.push_back(i);
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    IslandOf(contacts_[i].rows).contacts.push_back(i);
  }
  for (std::size_t i = 0; i < rollings_.size(); ++i) {
    IslandOf(rollings_[i].rows).rollings.push_back(i);
  }
}

double ConstraintSystem::RateOf(const JointRow& row) const {
  const double rate = speeds_[row.speed];
  return row.sign * (row.other < 0 ? rate : rate - speeds_[row.other]);
}

void ConstraintSystem::SolveTie(Tie& tie, Sweep& sweep) {
  const Vector3d more =
      -tie.inverse * (VelocityOf(tie.rows) + tie.softness * tie.rows.impulse + tie.bias_m_s);
  tie.rows.impulse += more;
  Push(tie.rows, more);
  sweep.force = std::max(sweep.force, more.lpNorm<Eigen::Infinity>());
  sweep.largest_force = std::max(sweep.largest_force, tie.rows.impulse.lpNorm<Eigen::Infinity>());
}

void ConstraintSystem::SolveJoint(Joint& joint, Sweep& sweep) {
  JointRow& row = joint.row;
  const double rate = RateOf(row), before = row.impulse;
  row.impulse = std::clamp(
      before - (rate + row.softness * before + row.bias_rad_s) / (joint.own + row.softness),
      row.low, row.high);
  PushJoint(joint, row.impulse - before);
  sweep.torque = std::max(sweep.torque, std::abs(row.impulse - before));
  sweep.largest_torque = std::max(sweep.largest_torque, std::abs(row.impulse));
}

// The normal first, then both directions across by what the normal leaves.
void ConstraintSystem::SolveContact(Contact& contact, Sweep& sweep) {
  const Vector3d velocity = VelocityOf(contact.rows);
  const Vector3d before = contact.rows.impulse;
  Vector3d& impulse = contact.rows.impulse;
  impulse[0] = std::max(
      0.0,
      before[0] - contact.along * (velocity[0] + contact.softness * before[0] + contact.bias_m_s));
  const Vector2d sliding =
      velocity.tail<2>() + (impulse[0] - before[0]) * contact.rows.own.col(0).tail<2>();
  const Vector2d rubbed = before.tail<2>();
  Vector2d rub =
      rubbed - contact.across * (sliding + contact.softness * rubbed + contact.unbend_m_s);
  const double most = contact.law.friction * impulse[0], size = rub.norm();
  if (size > most) rub *= most / size;
  impulse.tail<2>() = rub;
  const Vector3d more = impulse - before;
  contact.change = more;
  Push(contact.rows, more);
  sweep.force = std::max(sweep.force, more.lpNorm<Eigen::Infinity>());
  sweep.largest_force = std::max(sweep.largest_force, impulse[0]);
}

void ConstraintSystem::SolveRolling(Rolling& rolling, Sweep& sweep) {
  const Vector3d before = rolling.rows.impulse;
  Vector3d wanted = before - rolling.across * VelocityOf(rolling.rows);
  wanted[2] = 0.0;
  double load = contacts_[rolling.contact].rows.impulse[0];
  for (std::size_t i = rolling.contact + 1; i < rolling.end; ++i) {
    load += contacts_[i].rows.impulse[0];
  }
  const double most = rolling.resistance_m * load;
  const double size = wanted.norm();
  if (size > most) wanted *= most / size;
  rolling.rows.impulse = wanted;
  Push(rolling.rows, wanted - before);
  sweep.torque = std::max(sweep.torque, (wanted - before).lpNorm<Eigen::Infinity>());
  sweep.largest_torque = std::max(sweep.largest_torque, wanted.lpNorm<Eigen::Infinity>());
}

// Advances the bends by the velocities after the step.
void ConstraintSystem::Bend() {
  for (Contact& contact : contacts_) {
    ContactLaw& law = contact.law;
    law.bend_m += step_s_ * VelocityOf(contact.rows).tail<2>();
    const double most = law.friction * contact.rows.impulse[0] / (step_s_ * law.stiffness_n_per_m);
    const double size = law.bend_m.norm();
    if (size > most) law.bend_m *= most / size;
  }
}

DOCKYARD_FOUR_AT_ONCE int ConstraintSystem::SolveIsland(const Island& island) {
  // The last sweep's change of the contacts' impulses is the residual of a conjugate gradient; the
  // direction starts anew where it grows.
  double last = 0.0;
  const auto GoOn = [&] {
    double square = 0.0;
    for (const std::size_t i : island.contacts) square += contacts_[i].change.squaredNorm();
    const double kept = last > 0.0 && square <= last ? square / last : 0.0;
    last = square;
    for (const std::size_t i : island.contacts) {
      Contact& contact = contacts_[i];
      const Vector3d more = kept * contact.direction;
      contact.direction = more + contact.change;
      if (kept == 0.0) continue;
      contact.rows.impulse += more;
      Push(contact.rows, more);
    }
  };
  int sweeps = 0;
  while (sweeps < kMostSweeps) {
    if (sweeps > kPlainSweeps) GoOn();
    Sweep sweep;
    for (const std::size_t i : island.ties) SolveTie(ties_[i], sweep);
    for (const std::size_t i : island.joints) SolveJoint(joints_[i], sweep);
    for (const std::size_t i : island.contacts) SolveContact(contacts_[i], sweep);
    for (const std::size_t i : island.rollings) SolveRolling(rollings_[i], sweep);
    ++sweeps;
    if (sweep.IsLast(solved_)) break;
  }
  return sweeps;
}

int ConstraintSystem::Solve() {
  PushFirstGuesses();
  FindIslands();
  int sweeps = 0;
  for (int i = 0; i < island_count_; ++i) {
    sweeps = std::max(sweeps, SolveIsland(islands_[static_cast<std::size_t>(i)]));
  }
  Bend();
  return sweeps;
}

}  // namespace dockyard
