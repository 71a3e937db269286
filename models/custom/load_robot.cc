#include "models/custom/load_robot.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "models/custom/robot_file.h"
#include "models/custom/take_wheels.h"
#include "models/read/config_error.h"
#include "models/read/load_link_tree.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_spreads.h"
#include "models/read/near_names.h"
#include "models/read/other_kind.h"
#include "models/read/urdf.h"
#include "models/read/yaml_reader.h"

namespace dockyard::custom {
namespace {

int RequireJoint(const LinkTree& tree, const std::string& name, const std::string& place) {
  const int link = tree.LinkOfJoint(name);
  if (link >= 0) return link;
  std::vector<std::string> known;
  for (const JointedLink& each : tree.joints.links) known.push_back(each.joint);
  throw ConfigError(place + ": expected a joint of the URDF file that moves, found '" + name + "'" +
                    DidYouMeanOrKnown(name, known));
}

void TakeMotors(const YamlReader& in, const RobotFile& file, RobotModel& robot) {
  for (std::size_t i = 0; i < file.motors.size(); ++i) {
    const MotorsFile& group = file.motors[i];
    const std::string place = PlaceInList(in, "motors", i, "joints");
    for (const std::string& joint : group.joints) {
      MotorFit motor{joint, RequireJoint(robot.tree, joint, place), group.model};
      const JointedLink& moved = robot.tree.joint(motor.link);
      const bool screw = !std::isnan(group.lead_m_per_turn);
      if (moved.slides != screw) {
        throw ConfigError(place + ": expected " +
                          (screw ? "no lead_m_per_turn: '" + joint + "' turns"
                                 : "lead_m_per_turn of the slide '" + joint + "'"));
      }
      if (screw) motor.travel_per_rad = group.lead_m_per_turn / (2.0 * kPi);
      const auto same = [&](const MotorFit& each) { return each.joint == joint; };
      if (moved.motor || std::any_of(robot.motors.begin(), robot.motors.end(), same)) {
        throw ConfigError(place + ": expected one motor for '" + joint + "', found two");
      }
      robot.motors.push_back(std::move(motor));
    }
  }
}

void TakeNames(const YamlReader& in, const RobotFile& file) {
  std::vector<std::string> cameras, sensors;
  for (std::size_t i = 0; i < file.cameras.size(); ++i)
    TakeName(file.cameras[i].camera.name, PlaceInList(in, "cameras", i, "name"), cameras);
  for (std::size_t i = 0; i < file.switches.size(); ++i)
    TakeName(file.switches[i].name, PlaceInList(in, "switches", i, "name"), sensors);
  for (std::size_t i = 0; i < file.ranges.size(); ++i)
    TakeName(file.ranges[i].finder.name, PlaceInList(in, "range_finders", i, "name"), sensors);
}

void TakeSensors(const YamlReader& in, const RobotFile& file, RobotModel& robot) {
  for (std::size_t i = 0; i < file.switches.size(); ++i) {
    const SwitchFile& each = file.switches[i];
    const std::string place = PlaceInList(in, "switches", i, "joint");
    JointSwitch fit{each.name, RequireJoint(robot.tree, each.joint, place), 0.0, each.times};
    const bool slides = robot.tree.joint(fit.link).slides;
    fit.closes_rad = slides ? each.closes_m : each.closes_rad;
    if (std::isnan(fit.closes_rad)) {
      throw ConfigError(place + ": expected " + (slides ? "closes_m" : "closes_deg") + " of '" +
                        each.joint + "'");
    }
    robot.switches.push_back(std::move(fit));
  }
  for (std::size_t i = 0; i < file.ranges.size(); ++i) {
    const NamedFrame& frame =
        RequireFrame(robot.tree, file.ranges[i].link, PlaceInList(in, "range_finders", i, "link"));
    RangeFinder fit = file.ranges[i].finder;
    fit.link = frame.link;
    fit.X_LF = frame.X_LF;
    robot.ranges.push_back(std::move(fit));
  }
  for (std::size_t i = 0; i < file.cameras.size(); ++i) {
    const NamedFrame& frame = RequireFrame(robot.tree, file.cameras[i].camera.link,
                                           PlaceInList(in, "cameras", i, "link"));
    CameraFit fit{CameraOf(file.cameras[i]), frame.link};
    fit.model.X_LC = frame.X_LF * fit.model.X_LC;
    robot.cameras.push_back(std::move(fit));
  }
}

// Left is where y of the root is positive, with all joints at their starts.
void BuildOff(const RobotErrors& errors, RobotModel& robot) {
  const std::vector<Pose3> X_RL = StartPoses(robot.tree);
  for (WheelFit& wheel : robot.wheels) {
    const double y_m = (X_RL[static_cast<std::size_t>(wheel.link)] * wheel.p_LK).y();
    const double scale = y_m > 0.0   ? errors.left_radius_scale
                         : y_m < 0.0 ? errors.right_radius_scale
                                     : 1.0;
    wheel.tyre.radius_m *= scale;
    wheel.tyre.grip *= errors.tyre_grip_scale;
    wheel.on_soil.rim_radius_m *= scale;
  }
  for (MotorFit& motor : robot.motors) motor.model.gear_friction_nm *= errors.gear_friction_scale;
  for (SpringPin& pin : robot.electrical.pins) pin.p_L += errors.pad_L;
  for (ContactPad& pad : robot.electrical.pads) pad.X_LP.p += errors.pad_L;
}

void PutRobotErrorsIfLeftOut(YamlNode& root) {
  for (const char* key : {"mass_scale", "as_built.left_radius_scale", "as_built.right_radius_scale",
                          "as_built.gear_friction_scale", "as_built.tyre_grip_scale"}) {
    PutIfLeftOut(root, key, 1.0);
  }
  for (const char* key : {"as_built.pins_x_m", "as_built.pins_y_m", "as_built.pins_z_m"}) {
    PutIfLeftOut(root, key, 0.0);
  }
}

RobotModel ReadRobotFile(const std::string& path, const ModelChanges& changes, MeshStore* meshes) {
  YamlNode root = LoadModelYaml(path);
  if (root.Find("wheels") == nullptr && root.Find("boards") != nullptr)
    throw ConfigError(path + ": expected a robot's file, found a dock's: it has boards, no wheels");
  if (changes.nominal != nullptr) MergeYaml(root, *changes.nominal);
  PutRobotErrorsIfLeftOut(root);
  if (changes.built != nullptr) PutBuilt(root, *changes.built);
  RobotModel robot;
  RobotFile file;
  const auto visit = [&](Keys& keys) { VisitRobot(keys, robot, file); };
  ReadKeys(root, "", visit);
  const YamlReader in(root, "", KeyNames(visit));
  const UrdfModel urdf = LoadUrdf(file.urdf, meshes);
  robot.tree = TakeLinkTree(in, urdf, file.joints);
  ScaleMass(file.mass_scale, robot.tree);
  TakeWheels(in, urdf, file, robot);
  TakeMotors(in, file, robot);
  TakeNames(in, file);
  TakeSensors(in, file, robot);
  robot.electrical =
      TakePins(in, file.pins, [&](const std::string& name, const std::string& place) {
        const NamedFrame& frame = RequireFrame(robot.tree, name, place);
        return LinkPlace{frame.link, frame.X_LF};
      });
  BuildOff(file.errors, robot);
  CheckSpreads(root);
  return robot;
}

}  // namespace

void VisitRobotKeys(Keys& keys) {
  RobotModel robot;
  RobotFile file;
  VisitRobot(keys, robot, file);
}

bool IsRobotFile(const YamlNode& root) {
  return root.Find("urdf") != nullptr && root.Find("wheels") != nullptr &&
         root.Find("wheels")->kind == YamlNode::Kind::kSequence;
}

RobotModel LoadRobot(const std::string& file, const ModelChanges& changes, MeshStore* meshes) {
  return Advising(kGoOn, [&] { return ReadRobotFile(file, changes, meshes); });
}

}  // namespace dockyard::custom
