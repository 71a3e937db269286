#include "sim/axel/rover_body.h"

#include <cmath>
#include <utility>

#include "controller/io/sensors.h"
#include "sim/axel/cone_shapes.h"

namespace dockyard::axel {
namespace {

// Without what is drawn and what touches.
LinkModel InertialOf(const LinkModel& link) {
  return {link.name, link.mass_kg, link.p_LoCom_L, link.I_LCom_L, {}, {}};
}

}  // namespace

const LinkModel& LinkOf(const RoverModel& rover, RoverLink link) {
  switch (link) {
    case RoverLink::kBody:
      return rover.body;
    case RoverLink::kLeftWheel:
      return rover.left_wheel;
    case RoverLink::kRightWheel:
      return rover.right_wheel;
    case RoverLink::kArm:
      return rover.arm;
    case RoverLink::kFirstFurther:
      break;
  }
  return rover.further.links.at(static_cast<std::size_t>(link) - kOwnLinkCount).link;
}

RoverTree TreeOf(const RoverModel& rover, bool right_first) {
  std::vector<TreeLink> links(1);
  links[0].model = InertialOf(rover.body);
  const auto AddHinge = [&](RoverLink link, const Eigen::Vector3d& p_R, Motor motor) {
    TreeLink& hinged = links.emplace_back();
    hinged.model = InertialOf(LinkOf(rover, link));
    hinged.parent = 0;
    hinged.p_PL = p_R;
    hinged.rotor_kg_m2 = rover.motors[static_cast<std::size_t>(motor)].reflected_inertia_kg_m2;
  };
  for (const bool right : {right_first, !right_first}) {
    if (right) AddHinge(RoverLink::kRightWheel, rover.p_R_right_wheel, Motor::kRightWheel);
    if (!right) AddHinge(RoverLink::kLeftWheel, rover.p_R_left_wheel, Motor::kLeftWheel);
  }
  AddHinge(RoverLink::kArm, Eigen::Vector3d::Zero(), Motor::kArm);
  TreePlaces places =
      AddJointedLinks(rover.further, {0, right_first ? 2 : 1, right_first ? 1 : 2, 3}, links);
  return {std::move(links), std::move(places)};
}

std::vector<LinkParts> PartsOf(const RoverModel& rover) {
  std::vector<LinkParts> parts;
  for (int i = 0; i < LinkCount(rover); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    LinkParts& own = parts.emplace_back();
    own.collisions =
        link == RoverLink::kArm ? ArmCollisions(rover) : LinkOf(rover, link).collisions;
    if (link == RoverLink::kLeftWheel) own.wheel = rover.left_wheel_soil;
    if (link == RoverLink::kRightWheel) own.wheel = rover.right_wheel_soil;
  }
  return parts;
}

RoverBody::RoverBody(RigidWorld& world, const RoverModel& rover, const Pose3& X_GR, double arm_rad,
                     bool right_first)
    : world_(world) {
  RoverTree built = TreeOf(rover, right_first);
  tree_link_ = std::move(built.places);
  body_ = world.Add(TreeBody(std::move(built.links), TiesOf(rover.further, tree_link_), X_GR));
  tree().SetAngle(TreeLinkOf(RoverLink::kArm), arm_rad);
  SetStartAngles(rover.further, tree_link_, tree());
  LimitJoints(rover.further, tree_link_, body_, world);
  further_drives_ = JointDrives(rover.further, tree_link_, tree());
  if (!std::isfinite(rover.arm_lower_rad) && !std::isfinite(rover.arm_upper_rad)) return;
  world.Limit(Place(RoverLink::kArm),
              StopsAt(rover.arm_stop, rover.arm_lower_rad, rover.arm_upper_rad));
}

}  // namespace dockyard::axel
