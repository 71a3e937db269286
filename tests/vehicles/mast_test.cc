// A mast with an instrument: what its joints carry, and what its face feels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/read/load_model_yaml.h"
#include "models/read/load_rover.h"
#include "models/read/yaml_reader.h"
#include "sim/vehicles/boulder.h"
#include "sim/vehicles/face_contact.h"
#include "sim/vehicles/mast_body.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

MastModel MastOf(const YamlNode& tree) {
  RoverModel rover;
  const auto visit = [&](Keys& keys) {
    VisitRover(keys, rover);
    YamlNode other;
    for (const char* key : {"cameras", "back_cameras", "mast_cameras", "imu", "spreads"}) {
      keys.Tree(Unset(key), other, YamlNode::Kind::kNull);
    }
  };
  ReadRover(tree, visit, rover);
  return *rover.mast;
}

MastModel Rocky7Mast() { return MastOf(LoadModelYaml(SourceFile("models/rocky7/rocky7.yaml"))); }

// The mast alone, on a base that nothing moves.
struct Rig {
  MastModel mast = Rocky7Mast();
  TreeBody tree;

  explicit Rig(const Pose3& X_GB = {}) : tree(Links(mast), {}, X_GB) {}
  static std::vector<TreeLink> Links(const MastModel& mast) {
    std::vector<TreeLink> links(1);
    links[0].model.mass_kg = 1e9;
    links[0].model.I_LCom_L = 1e9 * Eigen::Matrix3d::Identity();
    for (const TreeLink& link : MastLinks(mast, 1)) links.push_back(link);
    return links;
  }
  Vector3d Face() const { return tree.motion(3).X_GL * Vector3d(mast.link2_m, 0.0, 0.0); }
};

TEST(Mast, ItsFaceIsWhereTheLinksPutIt) {
  Rig rig;
  const double roll = 0.3, shoulder = -1.1, elbow = 1.6;
  rig.tree.SetAngle(1, roll);
  rig.tree.SetAngle(2, shoulder);
  rig.tree.SetAngle(3, elbow);
  // Positive angles lower what hangs on a joint.
  const double ahead =
      rig.mast.link1_m * std::cos(shoulder) + rig.mast.link2_m * std::cos(shoulder + elbow);
  const double up =
      -rig.mast.link1_m * std::sin(shoulder) - rig.mast.link2_m * std::sin(shoulder + elbow);
  const Vector3d expected =
      rig.mast.p_RM + Vector3d(ahead * std::cos(roll), ahead * std::sin(roll), up);
  EXPECT_LT((rig.Face() - expected).norm(), 1e-12);
}

// From angular accelerations of the free joints, which are those of the torques that hold them.
TEST(Mast, JointsCarryTheMomentOfWhatHangsOnThem) {
  Rig rig;  // both links level
  constexpr double kG = 9.81, kStep_s = 1e-4;
  const MastModel& m = rig.mast;
  const double bar_m = m.link2_m - m.instrument.length_m;
  const double elbow_nm = kG * (m.link2_kg * 0.5 * bar_m +
                                m.instrument.mass_kg * (bar_m + 0.5 * m.instrument.length_m));
  const double shoulder_nm =
      elbow_nm + kG * m.link1_m * (0.5 * m.link1_kg + m.link2_kg + m.instrument.mass_kg);
  rig.tree.AddJointTorque(2, -shoulder_nm);
  rig.tree.AddJointTorque(3, -elbow_nm);
  rig.tree.AddForce(0, kG * rig.tree.link(0).model.mass_kg * Vector3d::UnitZ(), Vector3d::Zero());
  rig.tree.TakeLoads({0.0, 0.0, -kG}, kStep_s);
  rig.tree.Move(kStep_s);
  EXPECT_NEAR(rig.tree.rate_rad_s(2), 0.0, 1e-9);
  EXPECT_NEAR(rig.tree.rate_rad_s(3), 0.0, 1e-9);
  EXPECT_LT(shoulder_nm, m.motors[kMastShoulder].torque_per_amp_nm * m.motors[1].max_current_a);
  EXPECT_LT(elbow_nm, m.motors[kMastElbow].torque_per_amp_nm * m.motors[2].max_current_a);
}

TEST(Mast, AMotorTurnsTheInertiaOfTheStraightMast) {
  Rig rig;
  for (const int motor : {kMastShoulder, kMastElbow}) {
    const double moment = rig.tree.MassMatrix()(6 + motor, 6 + motor);
    EXPECT_NEAR(MastInertia(rig.mast, motor), moment, 0.02 * moment) << motor;
  }
}

TEST(Mast, FileNamesWhatIsWrong) {
  const auto read = [](const std::string& assignment) {
    YamlNode tree = LoadModelYaml(SourceFile("models/rocky7/rocky7.yaml"));
    SetYaml(tree, assignment);
    MastOf(tree);
  };
  EXPECT_NO_THROW(read("build.mast.link1_m=0.6"));
  EXPECT_THROW(read("build.mast.link2_m=0.1"), std::exception);  // shorter than the can
  EXPECT_THROW(read("build.mast.elbow.watch_deg=190"), std::exception);
  EXPECT_THROW(read("build.mast.instrument.closes_n=0"), std::exception);
}

// A flat wall at x = wall_m, facing the can, and a can that looks along x, tipped by some angle.
StarBody Wall(double wall_m) {
  return MakeStarBody({wall_m + 0.5, 0.0, 0.0}, 3,
                      [](const Vector3d& d) { return d.x() < -0.7 ? 0.5 / -d.x() : 0.7; });
}

struct Touch {
  double force_n = 0.0;
  std::array<bool, 3> closed{};
};

// The can alone, sliding on its spring along a link.
TreeBody CanOn(const LinkModel& carrier, const Pose3& X_GL, const TreeRules& rules) {
  std::vector<TreeLink> links{{carrier}, MastLinks(Rocky7Mast(), 0).back()};
  links[1].parent = 0;
  return TreeBody(links, {}, X_GL, rules);
}

// So many steps of a can whose link is held there.
Touch At(double overtravel_m, double tip_rad = 0.0, int steps = 1) {
  const MastModel mast = Rocky7Mast();
  LinkModel carrier;
  carrier.mass_kg = 1.0;
  Pose3 X_GL;
  X_GL.R = RotY(tip_rad);
  // The face's middle is brought to the wall, then in.
  X_GL.p = Vector3d(overtravel_m, 0.0, 0.0) - X_GL.R * Vector3d(mast.link2_m, 0.0, 0.0);
  RigidWorld world(Vector3d::Zero());
  world.Add(CanOn(carrier, X_GL, {TreeBase::kFixed}));
  FaceContact face(mast.instrument, {0, 1}, mast.link2_m);
  const StarBody wall = Wall(0.0);
  for (int i = 0; i < steps; ++i) {
    face.AddContacts(wall, world);
    world.Step(1e-3);
    face.TakeForces(world, 1e-3);
  }
  return {face.force_n(), face.closed()};
}
Touch Held(double overtravel_m, double tip_rad = 0.0) { return At(overtravel_m, tip_rad, 5000); }

// Springs in series: three switches and the mast; then the rim, 4 mm behind, beside the switches.
TEST(InstrumentFace, PressesByTheOvertravelThroughSpringsInSeries) {
  const InstrumentModel can = Rocky7Mast().instrument;
  const double switches = 3.0 * can.switch_n_per_m, rim = 12.0 * can.rim_n_per_m;
  const double before = switches * can.mast_n_per_m / (switches + can.mast_n_per_m);
  for (const double over_m : {0.0005, 0.002, 0.007}) {
    EXPECT_NEAR(Held(over_m).force_n, before * over_m, 1e-6) << over_m;
  }
  EXPECT_EQ(Held(-0.001).force_n, 0.0);
  for (const double over_m : {0.03, 0.04}) {
    // k u = s (d - u) + r (d - out - u)
    const double give_m =
        ((switches + rim) * over_m - rim * can.switch_out_m) / (can.mast_n_per_m + switches + rim);
    EXPECT_NEAR(Held(over_m).force_n, can.mast_n_per_m * give_m, 1e-6) << over_m;
  }
}

// At first the can's inertia holds it, and the switches alone yield.
TEST(InstrumentFace, AFastTouchPressesMore) {
  EXPECT_GT(At(0.001).force_n, 1.5 * Held(0.001).force_n);
  EXPECT_LT(At(0.001).force_n, 3.0 * Rocky7Mast().instrument.switch_n_per_m * 0.001);
}

TEST(InstrumentFace, ASwitchClosesAtItsForce) {
  const InstrumentModel can = Rocky7Mast().instrument;
  // All three alike: each bears a third.
  const double closes_m = can.closes_n / can.switch_n_per_m + 3.0 * can.closes_n / can.mast_n_per_m;
  EXPECT_FALSE(Held(0.99 * closes_m).closed[0]);
  const Touch touch = Held(1.01 * closes_m);
  EXPECT_TRUE(touch.closed[0] && touch.closed[1] && touch.closed[2]);
}

TEST(InstrumentFace, TheSwitchThatClosesFirstTellsWhichWayItIsTipped) {
  // Nose down: the upper switch leads, by 1.5 times sin 5 deg of 28 mm, 3.7 mm.
  const Touch down = Held(0.003, Radians(5.0));
  EXPECT_TRUE(down.closed[0]);
  EXPECT_FALSE(down.closed[1] || down.closed[2]);
  const Touch up = Held(0.005, Radians(-5.0));
  EXPECT_FALSE(up.closed[0]);
  EXPECT_TRUE(up.closed[1] && up.closed[2]);
}

// A mast of 1 kg that presses with 20 N and is pushed sideways. Switches and rim bear by their
// stiffness. The rim slides first; what it does not hold bends the switches.
TEST(InstrumentFace, HoldsASidePushUpToCoulombsLimit) {
  const MastModel mast = Rocky7Mast();
  const InstrumentModel& can = mast.instrument;
  const double press_n = 20.0, switches = 3.0 * can.switch_n_per_m, rim = 12.0 * can.rim_n_per_m;
  const double depth_m = (press_n + rim * can.switch_out_m) / (switches + rim);
  const double rim_n = rim * (depth_m - can.switch_out_m);
  for (const double share : {0.9, 1.1}) {
    LinkModel carrier;
    carrier.mass_kg = 1.0;
    carrier.I_LCom_L = 1e6 * Eigen::Matrix3d::Identity();  // it does not turn
    RigidWorld world(Vector3d::Zero());
    world.Add(CanOn(carrier, Pose3::Translation(-mast.link2_m, 0.0, 0.0), {}));
    FaceContact face(can, {0, 1}, mast.link2_m);
    const StarBody wall = Wall(0.0);
    const double push_n = share * can.friction * press_n;
    TreeBody& tree = world.body(0);
    for (int i = 0; i < 6000; ++i) {
      const double now_n = push_n * std::clamp((i - 1000) / 2000.0, 0.0, 1.0);
      tree.AddForce(0, {press_n, now_n, 0.0}, tree.motion(0).X_GL.p);
      tree.AddForce(0, -20.0 * tree.motion(0).v_GL_G, tree.motion(0).X_GL.p);  // comes to rest
      face.AddContacts(wall, world);
      world.Step(1e-3);
      face.TakeForces(world, 1e-3);
    }
    if (share < 1.0) {
      EXPECT_NEAR(face.force_n(), press_n, 0.01);
      EXPECT_NEAR(tree.motion(0).X_GL.p.y(), (push_n - can.friction * rim_n) / switches, 1e-4);
      EXPECT_LT(tree.motion(0).v_GL_G.norm(), 2e-3);
    } else {
      EXPECT_GT(tree.motion(0).v_GL_G.y(), 0.04);  // a newton over the drag
    }
  }
}

}  // namespace
}  // namespace dockyard
