#include "models/rocky7/load_robot.h"

#include "models/read/load_model_yaml.h"
#include "models/read/load_mounting.h"
#include "models/read/load_rover.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/read_imu.h"
#include "models/read/read_stereo.h"

namespace dockyard::rocky7 {
namespace {

// Assumed, 320 x 240 to 640 x 480: the paper gives no size.
constexpr PixelSize kImage{640, 480};

// A further pair of cameras: what its mapping leaves out is as the front pair has it.
void CompletePair(YamlNode& tree, const char* key) {
  const YamlNode* front = tree.Find("cameras");
  for (std::size_t i = 0; front != nullptr && i < tree.keys.size(); ++i) {
    if (tree.keys[i].name != key) continue;
    YamlNode whole = *front;
    MergeYaml(whole, tree.items[i]);
    tree.items[i] = std::move(whole);
  }
}

// It looks back: given as if the rover were turned about.
void TurnAbout(StereoRig& rig) {
  const Pose3 turn{RotZ(kPi), Eigen::Vector3d::Zero()};
  rig.X_RL = turn * rig.X_RL;
  rig.X_RQ = turn * rig.X_RQ;
}

struct RobotPairs {
  StereoFile front, back, mast;
};

void VisitRobot(Keys& keys, RobotModel& robot, RobotPairs& pairs) {
  VisitRover(keys, robot.rover);
  VisitStereo(keys, "cameras", pairs.front);
  if (keys.reads()) {
    VisitStereo(keys, "back_cameras", pairs.back);
    VisitStereo(keys, "mast_cameras", pairs.mast);
  } else {  // what they leave out is as the front pair has it
    YamlNode part;
    for (const char* key : {"back_cameras", "mast_cameras"}) {
      keys.Tree(key, part, YamlNode::Kind::kMapping);
    }
  }
  keys.Mapping("imu", [&](Keys& in) { VisitImu(in, robot.imu); });
  NameSpreads(keys);
}

}  // namespace

void VisitRobotKeys(Keys& keys) {
  RobotModel robot;
  RobotPairs pairs;
  VisitRobot(keys, robot, pairs);
}

static RobotModel ReadRobotFile(const std::string& file, const ModelChanges& changes) {
  YamlNode tree = LoadModelYaml(file);
  if (changes.nominal != nullptr) MergeYaml(tree, *changes.nominal);
  for (const char* key : {"back_cameras", "mast_cameras"}) CompletePair(tree, key);
  for (const char* key : {"cameras", "back_cameras", "mast_cameras"}) {
    PutMountingIfLeftOut(tree, std::string(key) + ".mounting");
  }
  if (changes.built != nullptr) PutBuilt(tree, *changes.built);
  RobotModel robot;
  RobotPairs pairs;
  const auto visit = [&](Keys& keys) { VisitRobot(keys, robot, pairs); };
  ReadRover(tree, visit, robot.rover);
  robot.front = StereoOf(pairs.front, {}, kImage);
  robot.back = StereoOf(pairs.back, {}, kImage);
  TurnAbout(robot.back.nominal);
  robot.mast_pair = StereoOf(pairs.mast, {}, kImage);
  const YamlReader in(tree, "", KeyNames(visit));
  CheckSpreads(tree);
  if (!TurningLine_m(robot.rover.plan.wheels)) {
    in.Refuse("wheels", "some fixed ones: odometry counts their turns");
  }
  if (robot.rover.suspension.kind != SuspensionKind::kRockerBogie) {
    in.Refuse("build", "a suspension of the kind rocker_bogie");
  }
  if (!robot.rover.arm) in.Refuse("build", "an arm");
  if (!robot.rover.mast) in.Refuse("build", "a mast");
  return robot;
}

RobotModel LoadRobot(const std::string& file, const ModelChanges& changes) {
  return AdvisingOtherKinds("robot", [&] { return ReadRobotFile(file, changes); });
}

}  // namespace dockyard::rocky7
