// A mast with an instrument: what its joints carry, and what its face feels.
#include <gtest/gtest.h>

#include <cmath>

#include "models/read/load_model_yaml.h"
#include "models/read/load_rover.h"
#include "models/read/yaml_reader.h"
#include "sim/physics/boulder.h"
#include "sim/physics/face_contact.h"
#include "sim/physics/mast_body.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

MastModel Rocky7Mast() {
  const YamlNode tree = LoadModelYaml(SourceFile("models/rocky7/rocky7.yaml"));
  const YamlReader in(tree, "",
                      RoverKeys({"cameras", "back_cameras", "mast_cameras", "imu", "spreads"}));
  return *ReadRover(in).mast;
}

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
    const YamlReader in(tree, "",
                        RoverKeys({"cameras", "back_cameras", "mast_cameras", "imu", "spreads"}));
    ReadRover(in);
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

Touch At(double overtravel_m, double tip_rad = 0.0, double speed_m_s = 0.0) {
  const MastModel mast = Rocky7Mast();
  // A base that stands for the link, with its face at x = link2_m.
  std::vector<TreeLink> links(1);
  links[0].model.mass_kg = 1.0;
  links[0].model.I_LCom_L = 0.01 * Eigen::Matrix3d::Identity();
  Pose3 X_GL;
  X_GL.R = RotY(tip_rad);
  // The face's middle is brought to the wall, then in.
  X_GL.p = Vector3d(overtravel_m, 0.0, 0.0) - X_GL.R * Vector3d(mast.link2_m, 0.0, 0.0);
  TreeBody tree(links, {}, X_GL);
  TreeBody::Speeds speeds = tree.speeds();
  speeds[0] = speed_m_s;
  tree.SetSpeeds(speeds);
  FaceContact face(mast.instrument, 0, mast.link2_m);
  face.Step(Wall(0.0), 1e-3, tree);
  return {face.force_n(), face.closed()};
}

TEST(InstrumentFace, PressesByItsSpringsTimesTheOvertravel) {
  const InstrumentModel can = Rocky7Mast().instrument;
  for (const double over_m : {0.0005, 0.001, 0.0019}) {  // the rim is 2 mm behind
    EXPECT_NEAR(At(over_m).force_n, 3.0 * can.stiffness_n_per_m * over_m, 1e-9) << over_m;
  }
  EXPECT_NEAR(At(0.001, 0.0, 0.05).force_n,
              3.0 * (can.stiffness_n_per_m * 0.001 + can.damping_ns_per_m * 0.05), 1e-9);
  EXPECT_EQ(At(-0.001).force_n, 0.0);
  // Beyond that the rim's twelve points press, too.
  EXPECT_NEAR(At(0.003).force_n, can.stiffness_n_per_m * (3.0 * 0.003 + 12.0 * 0.001), 1e-9);
}

TEST(InstrumentFace, ASwitchClosesAtItsForce) {
  const InstrumentModel can = Rocky7Mast().instrument;
  const double closes_m = can.closes_n / can.stiffness_n_per_m;
  EXPECT_FALSE(At(0.99 * closes_m).closed[0]);
  const Touch touch = At(1.01 * closes_m);
  EXPECT_TRUE(touch.closed[0] && touch.closed[1] && touch.closed[2]);
}

TEST(InstrumentFace, TheSwitchThatClosesFirstTellsWhichWayItIsTipped) {
  // Nose down: the upper switch leads. sin 5 deg of 28 mm is 2.4 mm.
  const Touch down = At(0.001, Radians(5.0));
  EXPECT_TRUE(down.closed[0]);
  EXPECT_FALSE(down.closed[1] || down.closed[2]);
  const Touch up = At(0.001, Radians(-5.0));
  EXPECT_FALSE(up.closed[0]);
  EXPECT_TRUE(up.closed[1] && up.closed[2]);
}

// A can of 1 kg that is pressed on by 20 N and pushed sideways.
TEST(InstrumentFace, HoldsASidePushUpToCoulombsLimit) {
  const MastModel mast = Rocky7Mast();
  const double press_n = 20.0;
  for (const double share : {0.9, 1.1}) {
    std::vector<TreeLink> links(1);
    links[0].model.mass_kg = 1.0;
    links[0].model.I_LCom_L = 1e6 * Eigen::Matrix3d::Identity();  // it does not turn
    Pose3 X_GL;
    X_GL.p.x() = -mast.link2_m;
    TreeBody tree(links, {}, X_GL);
    FaceContact face(mast.instrument, 0, mast.link2_m);
    const StarBody wall = Wall(0.0);
    const double push_n = share * mast.instrument.friction * press_n;
    for (int i = 0; i < 3000; ++i) {
      face.Step(wall, 1e-3, tree);
      tree.AddForce(0, {press_n, i < 1000 ? 0.0 : push_n, 0.0}, tree.motion(0).X_GL.p);
      tree.AddForce(0, -2.0 * tree.motion(0).v_GL_G, tree.motion(0).X_GL.p);  // comes to rest
      tree.TakeLoads(Vector3d::Zero(), 1e-3);
      tree.Move(1e-3);
    }
    if (share < 1.0) {
      EXPECT_LT(tree.motion(0).X_GL.p.y(), 0.01);
      EXPECT_LT(tree.motion(0).v_GL_G.norm(), 2e-3);
    } else {
      EXPECT_GT(tree.motion(0).v_GL_G.y(), 0.1);
    }
  }
}

}  // namespace
}  // namespace dockyard
