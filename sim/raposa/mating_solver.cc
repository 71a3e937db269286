#include "sim/raposa/mating_solver.h"

#include <algorithm>
#include <cmath>

#include "sim/rigid/bullet_math.h"

namespace dockyard::raposa {

bool MatingSolver::IsOurs() const {
  return m_tmpSolverContactConstraintPool.size() == 0 &&
         m_tmpSolverNonContactConstraintPool.size() == 0 &&
         m_multiBodyNonContactConstraints.size() == 0 &&
         m_multiBodyTorsionalFrictionContactConstraints.size() == 0 &&
         m_multiBodySpinningFrictionContactConstraints.size() == 0 &&
         m_multiBodyFrictionContactConstraints.size() ==
             2 * m_multiBodyNormalContactConstraints.size();
}

/// False where the row is between other bodies than the rows before.
bool MatingSolver::TakeRow(const btMultiBodySolverConstraint& from, Bodies& bodies, Row& row) {
  row = {.jacobian = Speeds::Zero(),
         .answer = Speeds::Zero(),
         .rhs = from.m_rhs,
         .softness = from.m_cfm,
         .per_speed = from.m_jacDiagABInv,
         .impulse = from.m_appliedImpulse,
         .friction = from.m_friction,
         .normal = from.m_frictionIndex};
  struct End {
    btMultiBody* articulated;
    int speeds, jacobian, free;
    const btVector3 &linear, &turning, &answer;
  };
  const End ends[2] = {
      {from.m_multiBodyA, from.m_deltaVelAindex, from.m_jacAindex, from.m_solverBodyIdA,
       from.m_contactNormal1, from.m_relpos1CrossNormal, from.m_angularComponentA},
      {from.m_multiBodyB, from.m_deltaVelBindex, from.m_jacBindex, from.m_solverBodyIdB,
       from.m_contactNormal2, from.m_relpos2CrossNormal, from.m_angularComponentB}};
  for (const End& end : ends) {
    if (end.articulated != nullptr) {
      if (bodies.articulated == nullptr) {
        bodies.articulated = end.articulated;
        bodies.speeds = end.speeds;
      }
      const int count = end.articulated->getNumDofs() + 6;
      if (bodies.articulated != end.articulated || count > kMostFreedoms) return false;
      for (int i = 0; i < count; ++i) {
        row.jacobian[i] += m_data.m_jacobians[end.jacobian + i];
        row.answer[i] += m_data.m_deltaVelocitiesUnitImpulse[end.jacobian + i];
      }
    } else {
      if (bodies.free < 0) bodies.free = end.free;
      if (bodies.free != end.free || end.free < 0) return false;
      const btVector3& per_kg = m_tmpSolverBodyPool[end.free].internalGetInvMass();
      row.jacobian.segment<3>(kMostFreedoms) += FromBullet(end.linear);
      row.jacobian.tail<3>() += FromBullet(end.turning);
      row.answer.segment<3>(kMostFreedoms) += FromBullet(end.linear * per_kg);
      row.answer.tail<3>() += FromBullet(end.answer);
    }
  }
  return true;
}

bool MatingSolver::TakeRows() {
  bodies_ = {};
  along_.resize(static_cast<std::size_t>(m_multiBodyNormalContactConstraints.size()));
  across_.resize(2 * along_.size());
  for (std::size_t i = 0; i < along_.size(); ++i) {
    const int k = static_cast<int>(i);
    if (!TakeRow(m_multiBodyNormalContactConstraints[k], bodies_, along_[i])) return false;
  }
  for (std::size_t i = 0; i < across_.size(); ++i) {
    const int k = static_cast<int>(i);
    if (!TakeRow(m_multiBodyFrictionContactConstraints[k], bodies_, across_[i])) return false;
    if (across_[i].normal != across_[i - i % 2].normal) return false;
  }
  if (bodies_.articulated == nullptr || bodies_.free < 0) return false;
  speeds_.setZero();
  for (int i = 0; i < bodies_.articulated->getNumDofs() + 6; ++i) {
    speeds_[i] = m_data.m_deltaVelocities[bodies_.speeds + i];
  }
  btSolverBody& free = m_tmpSolverBodyPool[bodies_.free];
  speeds_.segment<3>(kMostFreedoms) = FromBullet(free.internalGetDeltaLinearVelocity());
  speeds_.tail<3>() = FromBullet(free.internalGetDeltaAngularVelocity());
  taken_ = speeds_;
  return true;
}

/// Returns the change of speed at the contact.
double MatingSolver::Push(Row& row, double impulse) {
  const double more = impulse - row.impulse;
  row.impulse = impulse;
  speeds_ += more * row.answer;
  return std::abs(more / row.per_speed);
}

double MatingSolver::Sweep() {
  double most = 0.0;
  for (Row& row : along_) {
    most = std::max(most, Push(row, std::max(0.0, row.impulse + Wanted(row))));
  }
  for (std::size_t i = 0; i < across_.size(); i += 2) {
    Row &a = across_[i], &b = across_[i + 1];
    const double limit = a.friction * along_[static_cast<std::size_t>(a.normal)].impulse;
    if (limit == 0.0 && a.impulse == 0.0 && b.impulse == 0.0) continue;
    const double to_a = a.impulse + Wanted(a), to_b = b.impulse + Wanted(b);
    const double square = to_a * to_a + to_b * to_b;
    const double kept = square > limit * limit ? limit / std::sqrt(square) : 1.0;
    most = std::max({most, Push(a, kept * to_a), Push(b, kept * to_b)});
  }
  return most;
}

void MatingSolver::GiveBack() {
  for (std::size_t i = 0; i < along_.size(); ++i) {
    m_multiBodyNormalContactConstraints[static_cast<int>(i)].m_appliedImpulse = along_[i].impulse;
  }
  for (std::size_t i = 0; i < across_.size(); ++i) {
    m_multiBodyFrictionContactConstraints[static_cast<int>(i)].m_appliedImpulse =
        across_[i].impulse;
  }
  for (int i = 0; i < bodies_.articulated->getNumDofs() + 6; ++i) {
    m_data.m_deltaVelocities[bodies_.speeds + i] = speeds_[i];
  }
  const Speeds change = speeds_ - taken_;
  bodies_.articulated->applyDeltaVeeMultiDof2(change.data(), 1.0);
  bodies_.articulated->setPosUpdated(false);
  btSolverBody& free = m_tmpSolverBodyPool[bodies_.free];
  free.internalGetDeltaLinearVelocity() =
      ToBullet(Eigen::Vector3d(speeds_.segment<3>(kMostFreedoms)));
  free.internalGetDeltaAngularVelocity() = ToBullet(Eigen::Vector3d(speeds_.tail<3>()));
}

// All sweeps at the first call: Bullet ends when it is told that nothing is left.
btScalar MatingSolver::solveSingleIteration(int iteration, btCollisionObject** bodies,
                                            int numBodies, btPersistentManifold** manifoldPtr,
                                            int numManifolds, btTypedConstraint** constraints,
                                            int numConstraints,
                                            const btContactSolverInfo& infoGlobal,
                                            btIDebugDraw* debugDrawer) {
  if (m_multiBodyNormalContactConstraints.size() == 0 || !IsOurs() || !TakeRows()) {
    return btMultiBodyConstraintSolver::solveSingleIteration(
        iteration, bodies, numBodies, manifoldPtr, numManifolds, constraints, numConstraints,
        infoGlobal, debugDrawer);
  }
  sweeps_ = 0;
  double change_m_s = settled_m_s_;
  while (sweeps_ < infoGlobal.m_numIterations && !(change_m_s < settled_m_s_)) {
    change_m_s = Sweep();
    ++sweeps_;
  }
  GiveBack();
  return 0.0;
}

}  // namespace dockyard::raposa
