#include "sim/physics/rotors.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <utility>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr int kJoints = 3;
constexpr int kCoordinates = 6 + kJoints;

}  // namespace

Rotors::Rotors(btMultiBody& body, std::vector<double> inertia_kg_m2)
    : body_(body), inertia_kg_m2_(std::move(inertia_kg_m2)), speeds_rad_s_(kJoints) {
  DOCKYARD_CHECK(inertia_kg_m2_.size() == kJoints && body.getNumDofs() == kJoints);
  for (int i = 0; i < kJoints; ++i) {
    DOCKYARD_CHECK(inertia_kg_m2_[i] > 0.0);
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
