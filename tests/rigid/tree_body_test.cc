#include "sim/rigid/tree_body.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "rigid/drawn_trees.h"
#include "rigid/principal_inertia.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kStep_s = 1e-3;
const Vector3d kGravity(0.0, 0.0, -9.81);

/// The same tree as a body of Bullet's.
class BulletTree {
 public:
  explicit BulletTree(const std::vector<TreeLink>& links, bool fixed = false) {
    for (const TreeLink& link : links) inertia_.push_back(FindPrincipalInertia(link.model));
    const int joints = static_cast<int>(links.size()) - 1;
    body_ = std::make_unique<btMultiBody>(joints, links[0].model.mass_kg,
                                          ToBullet(inertia_[0].moments), fixed, false);
    for (int i = 1; i <= joints; ++i) {
      const TreeLink& link = links[static_cast<std::size_t>(i)];
      const PrincipalInertia &own = inertia_[static_cast<std::size_t>(i)],
                             &parent = inertia_[static_cast<std::size_t>(link.parent)];
      const btQuaternion turn = ToQuaternion(
          Eigen::Matrix3d(own.X_LP.R.transpose() * link.R_PL.transpose() * parent.X_LP.R));
      const btVector3 axis = ToBullet(Vector3d(own.X_LP.R.transpose() * link.axis_L)),
                      to_joint = ToBullet(
                          Vector3d(parent.X_LP.R.transpose() * (link.p_PL - parent.X_LP.p))),
                      to_com = ToBullet(Vector3d(own.X_LP.R.transpose() * own.X_LP.p)),
                      moments = ToBullet(own.moments);
      const double mass_kg = link.model.mass_kg;
      if (link.joint == JointKind::kHinge) {
        body_->setupRevolute(i - 1, mass_kg, moments, link.parent - 1, turn, axis, to_joint, to_com,
                             true);
      } else if (link.joint == JointKind::kSlide) {
        body_->setupPrismatic(i - 1, mass_kg, moments, link.parent - 1, turn, axis, to_joint,
                              to_com, true);
      } else {
        body_->setupFixed(i - 1, mass_kg, moments, link.parent - 1, turn, to_joint, to_com);
      }
    }
    body_->finalizeMultiDof();
    body_->setLinearDamping(0.0);
    body_->setAngularDamping(0.0);
    body_->setMaxAppliedImpulse(1e18);
    body_->setMaxCoordinateVelocity(1e9);
    body_->setBasePos(ToBullet(inertia_[0].X_LP.p));
    body_->setWorldToBaseRot(ToQuaternion(inertia_[0].X_LP.R.transpose()));
  }

  void AddJointTorque(int i, double torque_nm) { body_->addJointTorque(i - 1, torque_nm); }
  /// At its centre of mass.
  void AddLoad(int i, const Vector3d& force_G, const Vector3d& torque_G) {
    const btVector3 force = ToBullet(force_G), torque = ToBullet(torque_G);
    i == 0 ? body_->addBaseForce(force) : body_->addLinkForce(i - 1, force);
    i == 0 ? body_->addBaseTorque(torque) : body_->addLinkTorque(i - 1, torque);
  }

  /// With a differential between the joints a and b if a > 0: an impulse on both takes what their
  /// rates have in common.
  void Step(int a = 0, int b = 0) {
    const btVector3 gravity = ToBullet(kGravity);
    body_->addBaseForce(gravity * body_->getBaseMass());
    for (int i = 0; i < body_->getNumLinks(); ++i) {
      body_->addLinkForce(i, gravity * body_->getLinkMass(i));
    }
    numbers_.resize(body_->getNumDofs() + 7);
    vectors_.resize(body_->getNumDofs() + 7);
    matrices_.resize(body_->getNumDofs() + 7);
    body_->computeAccelerationsArticulatedBodyAlgorithmMultiDof(kStep_s, numbers_, vectors_,
                                                                matrices_, false, false, false);
    if (a > 0) Tie(a, b);
    body_->stepPositionsMultiDof(kStep_s);
    body_->clearForcesAndTorques();
  }

  double angle(int i) const { return body_->getJointPos(i - 1); }
  Pose3 X_GB() const {
    const Pose3 X_GP = {FromBullet(btMatrix3x3(body_->getWorldToBaseRot().inverse())),
                        FromBullet(body_->getBasePos())};
    return X_GP * Inverse(inertia_[0].X_LP);
  }

 private:
  void Tie(int a, int b) {
    const auto speeds = static_cast<std::size_t>(body_->getNumDofs() + 6);
    std::vector<btScalar> impulse(speeds, 0.0), answer(speeds, 0.0);
    const std::size_t at_a = static_cast<std::size_t>(a) + 5,
                      at_b = static_cast<std::size_t>(b) + 5;
    impulse[at_a] = impulse[at_b] = 1.0;
    body_->calcAccelerationDeltasMultiDof(impulse.data(), answer.data(), numbers_, vectors_);
    const double common = body_->getJointVel(a - 1) + body_->getJointVel(b - 1);
    body_->applyDeltaVeeMultiDof(answer.data(), -common / (answer[at_a] + answer[at_b]));
  }

  std::vector<PrincipalInertia> inertia_;
  std::unique_ptr<btMultiBody> body_;
  btAlignedObjectArray<btScalar> numbers_;  // scratch of Bullet's
  btAlignedObjectArray<btVector3> vectors_;
  btAlignedObjectArray<btMatrix3x3> matrices_;
};

TEST(TreeBody, MovesAsBulletsArticulatedBody) {
  RandomStream random(StreamKey(1, "trees"));
  for (int tree = 0; tree < 5; ++tree) {
    const int count = 4 + 4 * tree;
    const std::vector<TreeLink> links = AnyTree(random, count);
    TreeBody ours(links, {}, {});
    BulletTree bullets(links);
    for (int step = 0; step < 300; ++step) {
      for (int i = 1; i < count; ++i) {
        const double torque_nm = 0.3 * std::sin(0.02 * step + i);
        ours.AddJointTorque(i, torque_nm);
        bullets.AddJointTorque(i, torque_nm);
      }
      for (int i = 0; i < count; ++i) {
        const Vector3d force_G(0.2 * std::sin(0.05 * step + i), 0.1, 0.3 * std::cos(i)),
            torque_G(0.02 * std::cos(0.03 * step), 0.0, 0.01 * i);
        const Pose3& X_GL = ours.motion(i).X_GL;
        const Vector3d p_G = X_GL * Vector3d(0.2, 0.1 * i, -0.1),
                       com_G = X_GL * ours.link(i).model.p_LoCom_L;
        ours.AddForce(i, force_G, p_G);
        ours.AddTorque(i, torque_G);
        bullets.AddLoad(i, force_G, torque_G + (p_G - com_G).cross(force_G));
      }
      ours.TakeLoads(kGravity, kStep_s);
      ours.Move(kStep_s);
      bullets.Step();
    }
    const Pose3 X = ours.motion(0).X_GL, Y = bullets.X_GB();
    EXPECT_LT((X.p - Y.p).norm(), 1e-9) << count;
    EXPECT_LT((X.R - Y.R).norm(), 1e-9) << count;
    for (int i = 1; i < count; ++i) EXPECT_NEAR(ours.angle_rad(i), bullets.angle(i), 1e-9);
  }
}

// Hinges, slides and fixed joints in any directions, on a base that is free or fixed.
TEST(TreeBody, MovesAsBulletsArticulatedBodyWithAllKindsOfJoints) {
  RandomStream random(StreamKey(6, "joints"));
  double furthest = 0.0;
  for (int tree = 0; tree < 6; ++tree) {
    const int count = 6 + tree;
    const std::vector<TreeLink> links = AnyTreeOfAllJoints(random, count, tree);
    const bool fixed = tree % 2 == 1;
    TreeBody ours(links, {}, {}, {.base = fixed ? TreeBase::kFixed : TreeBase::kFree});
    BulletTree bullets(links, fixed);
    for (int step = 0; step < 300; ++step) {
      for (int i = 1; i < count; ++i) {
        if (ours.SpeedOf(i) < 0) continue;
        const double load = 0.3 * std::sin(0.02 * step + i);
        ours.AddJointTorque(i, load);
        bullets.AddJointTorque(i, load);
      }
      ours.TakeLoads(kGravity, kStep_s);
      ours.Move(kStep_s);
      bullets.Step();
    }
    const Pose3 X = ours.motion(0).X_GL, Y = bullets.X_GB();
    furthest = std::max({furthest, (X.p - Y.p).norm(), (X.R - Y.R).norm()});
    for (int i = 1; i < count; ++i) {
      if (ours.SpeedOf(i) < 0) continue;
      furthest = std::max(furthest, std::abs(ours.angle_rad(i) - bullets.angle(i)));
      EXPECT_GT(std::abs(ours.angle_rad(i)), 1e-4);
    }
  }
  EXPECT_LT(furthest, 1e-8);
}

TEST(TreeBody, HoldsADifferentialAsAnImpulseInBulletsBodyDoes) {
  RandomStream random(StreamKey(2, "differential"));
  std::vector<TreeLink> links = AnyTree(random, 6);
  links[1].parent = links[2].parent = 0;
  links[1].axis_L = links[2].axis_L = Vector3d::UnitY();
  TreeBody ours(links, {{{1, 1.0}, {2, 1.0}}}, {});
  BulletTree bullets(links);
  double most_rad = 0.0;
  for (int step = 0; step < 300; ++step) {
    ours.AddJointTorque(1, 2.0);
    bullets.AddJointTorque(1, 2.0);
    ours.TakeLoads(kGravity, kStep_s);
    ours.Move(kStep_s);
    bullets.Step(1, 2);
    most_rad = std::max(most_rad, std::abs(ours.angle_rad(1) + ours.angle_rad(2)));
  }
  EXPECT_GT(std::abs(ours.angle_rad(1)), 0.1);
  EXPECT_LT(most_rad, 1e-12);
  for (int i = 1; i < 6; ++i) EXPECT_NEAR(ours.angle_rad(i), bullets.angle(i), 1e-9);
  EXPECT_LT((ours.motion(0).X_GL.p - bullets.X_GB().p).norm(), 1e-9);
}

// Two bodies on one axle: q'' = torque / (I1 I2 / (I1 + I2) + J).
TEST(TreeBody, FeelsARotorInTheJointsOwnAccelerationAlone) {
  TreeLink base, wheel;
  base.model.mass_kg = wheel.model.mass_kg = 1.0;
  base.model.I_LCom_L = 0.3 * Eigen::Matrix3d::Identity();
  wheel.model.I_LCom_L = 0.1 * Eigen::Matrix3d::Identity();
  wheel.parent = 0;
  wheel.rotor_kg_m2 = 0.05;
  TreeBody body({base, wheel}, {}, {});
  body.AddJointTorque(1, 1.0);
  body.TakeLoads({0, 0, 0}, kStep_s);
  EXPECT_NEAR(body.rate_rad_s(1), kStep_s / (0.3 * 0.1 / 0.4 + 0.05), 1e-12);
  EXPECT_NEAR(0.3 * body.motion(0).w_GL_G.y() + 0.1 * body.motion(1).w_GL_G.y(), 0.0, 1e-12);
}

TEST(TreeBody, FallsAsSymplecticEulerFalls) {
  RandomStream random(StreamKey(3, "fall"));
  TreeBody body(AnyTree(random, 8), {}, {});
  for (int i = 0; i < 1000; ++i) {
    body.TakeLoads(kGravity, kStep_s);
    body.Move(kStep_s);
  }
  // Sum of g k dt^2 for k = 1..1000; nothing turns.
  EXPECT_NEAR(body.motion(0).X_GL.p.z(), -9.81 * 0.5 * 1.001, 1e-9);
  for (int i = 1; i < 8; ++i) EXPECT_NEAR(body.angle_rad(i), 0.0, 1e-9);
}

TEST(TreeBody, KeepsItsEnergyButByTheStepsFirstOrderError) {
  RandomStream random(StreamKey(4, "energy"));
  const std::vector<TreeLink> links = AnyTree(random, 10);
  const auto Drift = [&](double step_s) {
    TreeBody body(links, {}, {});
    TreeBody::Speeds speeds = TreeBody::Speeds::Zero(15);
    for (int i = 0; i < 15; ++i) speeds[i] = 0.3 * std::sin(1.0 + i);
    body.AddSpeeds(speeds);
    const double before = body.KineticEnergy();
    for (int i = 0; i < std::lround(0.5 / step_s); ++i) {
      body.TakeLoads({0, 0, 0}, step_s);
      body.Move(step_s);
    }
    return std::abs(body.KineticEnergy() / before - 1.0);
  };
  const double coarse = Drift(2e-3), fine = Drift(1e-3);
  EXPECT_LT(fine, 5e-3);
  EXPECT_LT(fine, 0.6 * coarse + 1e-9);
}

// Velocities of points by differences of places.
TEST(TreeBody, HasTheJacobianOfItsPoints) {
  RandomStream random(StreamKey(5, "jacobian"));
  TreeBody body(AnyTree(random, 9), {}, {});
  TreeBody::Speeds speeds = TreeBody::Speeds::Zero(14);
  for (int i = 0; i < 14; ++i) speeds[i] = random.Uniform(-1, 1);
  body.AddSpeeds(speeds);
  for (int i = 0; i < 9; ++i) {
    const Vector3d p_L = AnyVector(random, 0.3), p_G = body.motion(i).X_GL * p_L;
    const Vector3d v_G = body.JacobianOf(i, p_G) * speeds;
    EXPECT_LT((v_G - body.motion(i).VelocityAt(p_G)).norm(), 1e-12);
    TreeBody moved = body;
    moved.Move(1e-7);
    EXPECT_LT((1e7 * (moved.motion(i).X_GL * p_L - p_G) - v_G).norm(), 1e-5);
  }
}

// By the dense matrix of inertia.
TEST(TreeBody, AnswersImpulsesByItsInertiaWhateverItsShape) {
  RandomStream random(StreamKey(7, "answers"));
  for (const int count : {1, 2, 4, 9, 20}) {
    for (const TreeBase base : {TreeBase::kFree, TreeBase::kFixed}) {
      if (base == TreeBase::kFixed && count == 1) continue;
      TreeBody body(AnyTree(random, count), {}, {RotX(0.7), AnyVector(random, 1.0)}, {base});
      for (int i = 1; i < count; ++i) body.SetAngle(i, random.Uniform(-1.0, 1.0));
      body.TakeLoads({0, 0, 0}, kStep_s);
      TreeBody::LinkImpulses impulses(body.speeds().size(), 6);
      for (Eigen::Index i = 0; i < impulses.size(); ++i) impulses(i) = random.Uniform(-1.0, 1.0);
      TreeBody::LinkImpulses answers = impulses;
      body.AnswerInPlace(answers);
      EXPECT_LT((body.MassMatrix() * answers - impulses).norm(), 1e-11) << count;
      const TreeBody::Speeds one = body.Answer(impulses.col(1));
      EXPECT_LT((one - answers.col(1)).norm(), 1e-12 * one.norm()) << count;
    }
  }
}

TEST(TreeBody, RefusesLinksOutOfOrder) {
  TreeLink link;
  link.model.mass_kg = 1.0;
  TreeLink late = link;
  late.parent = 2;
  EXPECT_DEATH(TreeBody({link, late}, {}, {}), "check failed");
  EXPECT_DEATH(TreeBody({}, {}, {}), "check failed");
  link.model.mass_kg = 0.0;
  EXPECT_DEATH(TreeBody({link}, {}, {}), "check failed");
}

}  // namespace
}  // namespace dockyard
