#include "models/rocky7/load_robot.h"

#include "models/read/load_model_yaml.h"
#include "models/read/load_mounting.h"
#include "models/read/load_rover.h"
#include "models/read/load_spreads.h"
#include "models/read/read_imu.h"
#include "models/read/read_stereo.h"

namespace dockyard::rocky7 {
namespace {

// Assumed, 320 x 240 to 640 x 480: the paper gives no size.
constexpr PictureSize kImage{640, 480};

}  // namespace

RobotModel LoadRobot(const std::string& file, const ModelChanges& changes) {
  YamlNode tree = LoadModelYaml(file);
  if (changes.told != nullptr) MergeYaml(tree, *changes.told);
  PutMountingIfLeftOut(tree, "cameras.mounting");
  if (changes.built != nullptr) PutBuilt(tree, *changes.built);
  const YamlReader in(tree, "", RoverKeys({"cameras", "imu", "spreads"}));
  RobotModel robot;
  robot.rover = ReadRover(in);
  robot.front = ReadStereo(in, {}, kImage);
  robot.imu = ReadImu(in);
  CheckSpreads(tree);
  if (!TurningLine_m(robot.rover.plan.wheels)) {
    in.Refuse("wheels", "some fixed ones: odometry counts their turns");
  }
  if (robot.rover.suspension.kind != SuspensionKind::kRockerBogie) {
    in.Refuse("build", "a suspension of the kind rocker_bogie");
  }
  if (!robot.rover.arm) in.Refuse("build", "an arm");
  return robot;
}

}  // namespace dockyard::rocky7
