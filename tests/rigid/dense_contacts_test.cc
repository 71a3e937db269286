// Contacts against closed forms: rest on a spring, sticking, sliding, a wedge that jams.
#include <gtest/gtest.h>

#include <cmath>

#include "rigid/dense_contacts.h"

namespace dockyard {
namespace {

constexpr double kStep = 1e-3, kStiffness = 2e5, kDamping = 2e3;

/// A block of 10 kg that cannot turn, on contacts side by side in the plane z = 0, normal +z.
struct Block {
  double mass_kg = 10.0;
  Eigen::Vector3d p{0, 0, 0}, v{0, 0, 0};
  int contacts = 1;
  double friction = 0.5;
  ContactStep step;

  void Move(const Eigen::Vector3d& force) {
    v += kStep * force / mass_kg;
    step.count = contacts;
    const int rows = 3 * contacts;
    if (step.impulse.size() != rows) step.impulse = ContactStep::Vector::Zero(rows);
    step.velocity.resize(rows);
    step.answer.resize(rows, rows);
    for (int i = 0; i < contacts; ++i) {
      step.laws[i].gap_m = p.z();
      step.laws[i].friction = friction;
      step.laws[i].stiffness_n_per_m = kStiffness;
      step.laws[i].damping_ns_per_m = kDamping;
      step.velocity.segment<3>(3 * i) << v.z(), v.x(), v.y();
      for (int k = 0; k < contacts; ++k) {
        step.answer.block<3, 3>(3 * i, 3 * k) = Eigen::Matrix3d::Identity() / mass_kg;
      }
    }
    SolveContacts(kStep, step);
    for (int i = 0; i < contacts; ++i) {
      const Eigen::Vector3d impulse = step.impulse.segment<3>(3 * i);
      v += Eigen::Vector3d(impulse.y(), impulse.z(), impulse.x()) / mass_kg;
    }
    p += kStep * v;
  }
};

TEST(DenseContacts, BlockRestsAsDeepAsItsSpringsSay) {
  for (int contacts : {1, 3}) {
    Block block;
    block.contacts = contacts;
    for (int i = 0; i < 2000; ++i) block.Move({0.0, 0.0, -98.1});
    EXPECT_NEAR(block.p.z(), -98.1 / (contacts * kStiffness), 1e-9);
    EXPECT_NEAR(block.v.norm(), 0.0, 1e-9);
  }
}

TEST(DenseContacts, BlockSticksBelowTheFrictionAngleWithoutCreeping) {
  Block block;
  for (int i = 0; i < 3000; ++i) block.Move({48.0, 0.0, -98.1});  // 0.49 of the weight
  EXPECT_NEAR(block.p.x(), 48.0 / kStiffness, 1e-7);              // the bend alone
  EXPECT_NEAR(block.v.x(), 0.0, 1e-9);
}

TEST(DenseContacts, BlockSlidesByWhatFrictionLeaves) {
  // From rest on its spring, pushed with 0.7 of its weight against a friction of 0.5.
  Block block;
  for (int i = 0; i < 2000; ++i) block.Move({0.0, 0.0, -98.1});
  for (int i = 0; i < 100; ++i) block.Move({0.7 * 98.1, 0.0, -98.1});  // until it slides
  const double before = block.v.x();
  for (int i = 0; i < 1000; ++i) block.Move({0.7 * 98.1, 0.0, -98.1});
  EXPECT_NEAR(block.v.x() - before, 0.2 * 9.81, 1e-6);
}

TEST(DenseContacts, FrictionPointsAgainstTheSliding) {
  Block block;
  block.v = {0.3, 0.4, 0.0};
  block.p.z() = -98.1 / kStiffness;
  for (int i = 0; i < 50; ++i) block.Move({0.0, 0.0, -98.1});
  EXPECT_NEAR(block.v.y() / block.v.x(), 4.0 / 3.0, 1e-6);
  EXPECT_NEAR(block.v.head<2>().norm(), 0.5 - 0.5 * 9.81 * 0.05, 2e-3);
}

TEST(DenseContacts, OpenGapClosesAndNoFurther) {
  Block block;
  block.p.z() = 0.4e-4;
  block.v.z() = -0.05;  // would pass the plane by a hundredth of a millimetre
  block.Move({0.0, 0.0, 0.0});
  EXPECT_LT(block.p.z(), 0.0);
  EXPECT_GT(block.p.z(), -1e-5);  // it gives way, less than without a contact
  EXPECT_GT(block.step.impulse[0], 0.0);
}

TEST(DenseContacts, BlowTakesAsLongAsSpringAndMassSay) {
  // Without a damper: half a period of sqrt(k / m), peak force v sqrt(k m).
  Block block;
  block.v.z() = -0.1;
  double peak = 0.0;
  int touched = 0;
  for (int i = 0; i < 400; ++i) {
    ContactStep& step = block.step;
    step.count = 1;
    step.laws[0] = {block.p.z(), 0.0, kStiffness, 0.0, {0.0, 0.0}};
    step.velocity.resize(3);
    step.velocity << block.v.z(), 0.0, 0.0;
    step.impulse = ContactStep::Vector::Zero(3);
    step.answer = Eigen::Matrix3d::Identity() / block.mass_kg;
    SolveContacts(1e-4, step);
    block.v.z() += step.impulse[0] / block.mass_kg;
    block.p.z() += 1e-4 * block.v.z();
    peak = std::max(peak, step.impulse[0] / 1e-4);
    touched += step.impulse[0] > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(peak, 0.1 * std::sqrt(kStiffness * 10.0), 0.02 * peak);
  EXPECT_NEAR(touched * 1e-4, 3.14159 * std::sqrt(10.0 / kStiffness), 1e-3);
}

}  // namespace
}  // namespace dockyard
