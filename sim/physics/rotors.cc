#include "sim/physics/rotors.h"

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <utility>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr int kJoints = 3;
constexpr int kCoordinates = 6 + kJoints;
constexpr double kNoLimit = 1e18;

class RotorRow : public btMultiBodyConstraint {
 public:
  RotorRow(btMultiBody& body, int link, double inertia_kg_m2)
      : btMultiBodyConstraint(&body, nullptr, link, -1, 1, false,
                              MULTIBODY_CONSTRAINT_1DOF_JOINT_MOTOR),
        inertia_kg_m2_(inertia_kg_m2) {
    finalizeMultiDof();
  }

  void finalizeMultiDof() override {
    allocateJacobiansMultiDof();
    jacobianA(0)[6 + m_linkA] = 1.0;
    m_numDofsFinalized = m_jacSizeBoth;
  }
  int getIslandIdA() const override { return m_bodyA->getBaseCollider()->getIslandTag(); }
  int getIslandIdB() const override { return getIslandIdA(); }

  void debugDraw(btIDebugDraw*) override {}

  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override {
    btMultiBodySolverConstraint& row = rows.expandNonInitializing();
    row.m_orgConstraint = this;
    row.m_orgDofIndex = 0;
    const btVector3 none(0, 0, 0);
    fillMultiBodyConstraint(row, data, jacobianA(0), nullptr, none, none, none, none, 0.0, info,
                            -kNoLimit, kNoLimit);
    // Bullet leaves the softness out of the row's diagonal, which then would not converge.
    const double softness = 1.0 / inertia_kg_m2_;
    row.m_jacDiagABInv = 1.0 / (1.0 / row.m_jacDiagABInv + softness);
    row.m_cfm = softness * row.m_jacDiagABInv;
    row.m_rhs = 0.0;
    row.m_rhsPenetration = 0.0;
    row.m_contactNormal1 = row.m_contactNormal2 = none;
    row.m_relpos1CrossNormal = row.m_relpos2CrossNormal = none;
  }

 private:
  double inertia_kg_m2_ = 0.0;
};

}  // namespace

Rotors::Rotors(btMultiBody& body, std::vector<double> inertia_kg_m2)
    : body_(body), inertia_kg_m2_(std::move(inertia_kg_m2)), speeds_rad_s_(kJoints) {
  DOCKYARD_CHECK(inertia_kg_m2_.size() == kJoints && body.getNumDofs() == kJoints);
  for (int i = 0; i < kJoints; ++i) {
    DOCKYARD_CHECK(inertia_kg_m2_[i] > 0.0);
    rows_.push_back(std::make_unique<RotorRow>(body, i, inertia_kg_m2_[i]));
  }
}

void Rotors::RememberSpeeds() {
  for (int i = 0; i < kJoints; ++i) speeds_rad_s_[i] = body_.getJointVel(i);
}

void Rotors::TakeTheirShare() {
  std::array<std::array<btScalar, kCoordinates>, kJoints> answers;  // to a unit torque on a joint
  Eigen::Matrix3d A;
  Eigen::Vector3d gained;
  for (int i = 0; i < kJoints; ++i) {
    std::array<btScalar, kCoordinates> torque{};
    torque[6 + i] = 1.0;
    body_.calcAccelerationDeltasMultiDof(torque.data(), answers[i].data(), scratch_r_, scratch_v_);
    gained[i] = body_.getJointVel(i) - speeds_rad_s_[i];
    for (int j = 0; j < kJoints; ++j) A(j, i) = answers[i][6 + j];
    A(i, i) += 1.0 / inertia_kg_m2_[i];
  }
  const Eigen::Vector3d impulse = A.inverse() * gained;
  for (int i = 0; i < kJoints; ++i) {
    body_.applyDeltaVeeMultiDof(answers[i].data(), -impulse[i]);
  }
}

}  // namespace dockyard
