#include "models/custom/take_wheels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "models/read/config_error.h"
#include "models/read/load_link_tree.h"
#include "models/read/yaml_reader.h"

namespace dockyard::custom {
namespace {

/// Radius and width of a link's only cylinder about its axle.
std::optional<TyreModel> TyreOfShape(const JointedLink& wheel, TyreModel tyre) {
  if (wheel.link.collisions.size() != 1) return std::nullopt;
  const Collision& part = wheel.link.collisions[0];
  if (const auto* cylinder = std::get_if<CylinderShape>(&part.shape)) {
    if (std::abs(part.X_LG.R.col(2).dot(wheel.axis_L)) < 1.0 - 1e-6) return std::nullopt;
    tyre.radius_m = cylinder->radius_m;
    if (tyre.width_m == 0.0) tyre.width_m = cylinder->length_m;
    return tyre;
  }
  return std::nullopt;
}

bool HasOneSphere(const LinkModel& link) {
  return link.collisions.size() == 1 &&
         std::holds_alternative<SphereShape>(link.collisions[0].shape);
}

bool IsBall(const TyreModel& tyre, const UrdfModel& urdf, const std::string& name) {
  return tyre.ball || (tyre.radius_m == 0.0 && HasOneSphere(urdf.Link(name)));
}

// Its socket may be fixed to the robot.
WheelFit BallOf(const UrdfModel& urdf, const std::string& name, const NamedFrame& frame,
                const WheelsFile& file, const std::string& place) {
  WheelFit ball;
  ball.link = frame.link;
  ball.tyre = file.tyre;
  ball.tyre.ball = true;
  ball.p_LK = frame.X_LF.p;
  const LinkModel& own = urdf.Link(name);
  if (HasOneSphere(own)) {
    ball.p_LK = frame.X_LF * own.collisions[0].X_LG.p;
    ball.tyre.radius_m = std::get<SphereShape>(own.collisions[0].shape).radius_m;
  } else if (ball.tyre.radius_m == 0.0) {
    throw ConfigError(place + ": expected tyre.radius_m, or one sphere as the collision of '" +
                      name + "'");
  }
  ball.on_soil.rim_radius_m = ball.tyre.radius_m;
  ball.on_soil.width_m = kLeastWidth_m;
  return ball;
}

// The ground bears a ball by its tyre, so it is none of its link's solids.
void TakeBallsOut(RobotModel& robot) {
  for (const WheelFit& wheel : robot.wheels) {
    if (!wheel.tyre.ball) continue;
    LinkModel& link = wheel.link == 0
                          ? robot.tree.root
                          : robot.tree.joints.links[static_cast<std::size_t>(wheel.link - 1)].link;
    std::erase_if(link.collisions, [&](const Collision& part) {
      return std::holds_alternative<SphereShape>(part.shape) &&
             (part.X_LG.p - wheel.p_LK).norm() < 1e-9;
    });
  }
}

WheelFit WheelOf(const LinkTree& tree, const UrdfModel& urdf, const std::string& name,
                 const WheelsFile& file, const std::string& place) {
  const NamedFrame& frame = RequireFrame(tree, name, place);
  WheelFit wheel;
  wheel.link = frame.link;
  wheel.tyre = file.tyre;
  if (IsBall(wheel.tyre, urdf, name)) return BallOf(urdf, name, frame, file, place);
  if (frame.link == 0 || !frame.X_LF.p.isZero(0.0)) {
    throw ConfigError(place + ": expected a link on a joint that turns, found '" + name +
                      "', which is fixed");
  }
  const JointedLink& joint = tree.joint(frame.link);
  if (joint.slides)
    throw ConfigError(place + ": expected a joint that turns, '" + name + "' slides");
  wheel.axle_L = joint.axis_L;
  if (wheel.tyre.radius_m == 0.0) {
    const std::optional<TyreModel> shaped = TyreOfShape(joint, wheel.tyre);
    if (!shaped) {
      throw ConfigError(place +
                        ": expected tyre.radius_m, or one cylinder about its axle or one "
                        "sphere as the collision of '" +
                        name + "'");
    }
    wheel.tyre = *shaped;
  }
  wheel.on_soil = file.on_soil;
  wheel.on_soil.rim_radius_m = wheel.tyre.radius_m - PaddleReach(file.on_soil);
  wheel.on_soil.width_m = std::max(wheel.tyre.width_m, kLeastWidth_m);
  return wheel;
}

// The left is to the left of the root, with all joints at their starts.
void PointAxlesLeft(const LinkTree& tree, std::vector<WheelFit>& wheels) {
  const std::vector<Pose3> X_RL = StartPoses(tree);
  for (WheelFit& wheel : wheels) {
    const Eigen::Vector3d axle_R = X_RL[static_cast<std::size_t>(wheel.link)].R * wheel.axle_L;
    if (axle_R.y() < 0.0) wheel.axle_L = -wheel.axle_L;
  }
}

}  // namespace

std::string PlaceInList(const YamlReader& in, const char* list, std::size_t i, const char* key) {
  const YamlNode& item = in.List(list, 0, 1000).items[i];
  const YamlNode* value = item.Find(key);
  return (value == nullptr ? item : *value).place.Text() + ": " +
         YamlReader::PathOf(in.PathOf(list), i) + "." + key;
}

void TakeWheels(const YamlReader& in, const UrdfModel& urdf, const RobotFile& file,
                RobotModel& robot) {
  for (std::size_t i = 0; i < file.wheels.size(); ++i) {
    const std::string place = PlaceInList(in, "wheels", i, "links");
    for (const std::string& link : file.wheels[i].links) {
      const WheelFit wheel = WheelOf(robot.tree, urdf, link, file.wheels[i], place);
      const auto same = [&](const WheelFit& each) { return each.link == wheel.link; };
      if (std::any_of(robot.wheels.begin(), robot.wheels.end(), same)) {
        throw ConfigError(place + ": expected each wheel once, found '" + link + "' again");
      }
      robot.wheels.push_back(wheel);
    }
  }
  PointAxlesLeft(robot.tree, robot.wheels);
  TakeBallsOut(robot);
}

}  // namespace dockyard::custom
