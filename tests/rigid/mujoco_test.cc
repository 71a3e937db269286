// Our trees against the same trees in MuJoCo where nothing touches.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "models/parts/gravity.h"
#include "rigid/drawn_trees.h"
#include "rigid/mujoco_tree.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

const Vector3d kMujocoDown(0.0, 0.0, -kEarthGravity_m_s2);

/// All kinds of joints, with rotors and dampers.
std::vector<TreeLink> AnyDrivenTree(RandomStream& random, int count, int first) {
  std::vector<TreeLink> links = AnyTreeOfAllJoints(random, count, first);
  for (TreeLink& link : links) {
    link.rotor_kg_m2 = random.Uniform(0.0, 0.05);
    link.damping_nms_per_rad = random.Uniform(0.0, 0.5);
  }
  return links;
}

TreeBody DrawnState(RandomStream& random, const std::vector<TreeLink>& links, TreeBase base) {
  const Pose3 X_GB =
      base == TreeBase::kFree
          ? Pose3{ToRotation({random.Uniform(-3, 3), random.Uniform(-1, 1), random.Uniform(-3, 3)}),
                  AnyVector(random, 2.0)}
          : Pose3{};
  TreeBody body(links, {}, X_GB, {base});
  for (int i = 1; i < body.link_count(); ++i) {
    if (body.SpeedOf(i) >= 0) body.SetAngle(i, random.Uniform(-2.0, 2.0));
  }
  TreeBody::Speeds speeds = body.speeds();
  for (double& speed : speeds) speed = random.Uniform(-3.0, 3.0);
  body.AddSpeeds(speeds);
  return body;
}

void AddAnyLoads(RandomStream& random, TreeBody& ours, MujocoTree& theirs) {
  for (int i = 0; i < ours.link_count(); ++i) {
    const Vector3d force_G = AnyVector(random, 20.0), torque_G = AnyVector(random, 3.0);
    const Vector3d p_G = ours.motion(i).X_GL * AnyVector(random, 0.5);
    ours.AddForce(i, force_G, p_G);
    theirs.AddForce(i, force_G, p_G);
    ours.AddTorque(i, torque_G);
    theirs.AddTorque(i, torque_G);
    if (ours.SpeedOf(i) < 0) continue;
    const double torque_nm = random.Uniform(-5.0, 5.0);
    ours.AddJointTorque(i, torque_nm);
    theirs.AddJointTorque(i, torque_nm);
  }
}

template <class Check>
void ForDrawnTrees(const char* stream, const Check& check) {
  RandomStream random(StreamKey(1, stream));
  for (int tree = 0; tree < 12; ++tree) {
    const TreeBase base = tree % 2 == 0 ? TreeBase::kFree : TreeBase::kFixed;
    check(random, AnyDrivenTree(random, 2 + tree, tree), base);
  }
}

TEST(MujocoTree, HasTheSameInertia) {
  double worst = 0.0;
  ForDrawnTrees("inertia", [&](RandomStream& random, const auto& links, TreeBase base) {
    MujocoTree theirs(links, base, {});
    for (int state = 0; state < 20; ++state) {
      const TreeBody ours = DrawnState(random, links, base);
      theirs.Take(ours);
      const TreeBody::Inertia M = ours.MassMatrix();
      worst = std::max(worst, (theirs.MassMatrix() - M).norm() / M.norm());
    }
  });
  RecordProperty("worst_1e15", std::to_string(1e15 * worst));
  EXPECT_LT(worst, 1e-12);
}

// Both take loads at the step's start and joints' dampers at its end.
TEST(MujocoTree, ChangesItsSpeedsByTheSameUnderAllLoads) {
  double worst = 0.0;
  ForDrawnTrees("loads", [&](RandomStream& random, const auto& links, TreeBase base) {
    for (const double step_s : {1e-5, 1e-3}) {
      MujocoTree theirs(links, base, {step_s, kMujocoDown});
      for (int state = 0; state < 20; ++state) {
        TreeBody ours = DrawnState(random, links, base);
        theirs.Take(ours);
        AddAnyLoads(random, ours, theirs);
        const Eigen::VectorXd before = ours.speeds();
        ours.TakeLoads(kMujocoDown, step_s);
        const Eigen::VectorXd wanted = ours.speeds() - before;
        theirs.Step();
        worst = std::max(worst, (theirs.speeds() - before - wanted).norm() / wanted.norm());
      }
    }
  });
  RecordProperty("worst_1e15", std::to_string(1e15 * worst));
  EXPECT_LT(worst, 1e-9);
}

double Apart(const TreeBody& ours, const MujocoTree& theirs, TreeBase base) {
  double apart = 0.0;
  if (base == TreeBase::kFree) {
    const Pose3 X = ours.motion(0).X_GL, Y = theirs.X_GB();
    apart = std::max((X.p - Y.p).norm(), (X.R - Y.R).norm());
  }
  for (int i = 1; i < ours.link_count(); ++i) {
    if (ours.SpeedOf(i) < 0) continue;
    apart = std::max(apart, std::abs(ours.angle_rad(i) - theirs.angle_rad(i)));
  }
  return apart;
}

// Both steps are semi-implicit Euler's, so only rounding parts them.
TEST(MujocoTree, MovesAlikeForASecond) {
  double worst = 0.0;
  ForDrawnTrees("motion", [&](RandomStream& random, const auto& links, TreeBase base) {
    const double step_s = 1e-3;
    TreeBody ours = DrawnState(random, links, base);
    MujocoTree theirs(links, base, {step_s, kMujocoDown});
    theirs.Take(ours);
    for (int step = 0; step < 1000; ++step) {
      for (int i = 1; i < ours.link_count(); ++i) {
        if (ours.SpeedOf(i) < 0) continue;
        const double torque_nm = 2.0 * std::sin(0.02 * step + i);
        ours.AddJointTorque(i, torque_nm);
        theirs.AddJointTorque(i, torque_nm);
      }
      ours.TakeLoads(kMujocoDown, step_s);
      ours.Move(step_s);
      theirs.Step();
    }
    worst = std::max(worst, Apart(ours, theirs, base));
  });
  RecordProperty("worst_1e15", std::to_string(1e15 * worst));
  EXPECT_LT(worst, 1e-9);
}

/// MuJoCo's by Runge and Kutta's fourth order in steps of 0.1 ms is the reference for 0.5 s.
double ApartFromFineMotion(const std::vector<TreeLink>& links, const TreeBody& start,
                           const TreeRules& rules, double step_s) {
  const double fine_s = 1e-4, seconds = 0.5;
  MujocoTree theirs(links, rules.base, {fine_s, kMujocoDown, "RK4"});
  theirs.Take(start);
  TreeBody ours = start;
  // Speeds belong to the middle of steps: the first to half a step before the start.
  TreeBody before = start;
  before.TakeLoads(kMujocoDown, -0.5 * step_s);
  ours.AddSpeeds(before.speeds() - ours.speeds());
  for (long i = 0; i < std::lround(seconds / fine_s); ++i) theirs.Step();
  for (long i = 0; i < std::lround(seconds / step_s); ++i) {
    ours.TakeLoads(kMujocoDown, step_s);
    ours.Move(step_s);
  }
  return Apart(ours, theirs, rules.base);
}

void ExpectSecondOrder(const std::vector<TreeLink>& links, const TreeBody& start,
                       const TreeRules& rules) {
  double finer = 0.0;
  for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
    const double apart = ApartFromFineMotion(links, start, rules, step_s);
    testing::Test::RecordProperty("apart_" + std::to_string(std::lround(1e6 * step_s)) + "us_1e9",
                                  std::to_string(1e9 * apart));
    EXPECT_LT(apart, 3e-5);
    if (finer > 0.0) {
      EXPECT_NEAR(apart / finer, 4.0, 0.2);
    }
    finer = apart;
  }
}

TEST(MujocoTree, FineMotionIsReachedInSecondOrderByTermsOfMidstep) {
  RandomStream random(StreamKey(2, "midstep"));
  const TreeRules rules{TreeBase::kFixed, VelocityTerms::kMidstep};
  std::vector<TreeLink> links = AnyTreeOfAllJoints(random, 4, 0);
  links[1].joint = links[3].joint = JointKind::kHinge;
  ExpectSecondOrder(links, TreeBody(links, {}, {}, rules), rules);
}

TEST(MujocoTree, FineTumblingIsReachedInSecondOrderByAFreeBody) {
  RandomStream random(StreamKey(3, "tumbling"));
  const std::vector<TreeLink> links = AnyTree(random, 1);
  TreeBody start(links, {}, {});
  TreeBody::Speeds speeds(6);
  speeds << 0.1, -0.2, 0.3, 4.0, -3.0, 2.0;
  start.AddSpeeds(speeds);
  ExpectSecondOrder(links, start, {});
}

}  // namespace
}  // namespace dockyard
