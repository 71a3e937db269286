#include "sim/axel/rover_body.h"

#include <cmath>

#include "controller/io/sensors.h"

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
  }
  return rover.body;
}

std::vector<TreeLink> RoverLinks(const RoverModel& rover, bool right_first) {
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
  return links;
}

RoverBody::RoverBody(RigidWorld& world, const RoverModel& rover, const Pose3& X_GR, double arm_rad,
                     bool right_first)
    : world_(world),
      body_(world.Add(TreeBody(RoverLinks(rover, right_first), {}, X_GR))),
      tree_link_{0, right_first ? 2 : 1, right_first ? 1 : 2, 3} {
  tree().SetAngle(TreeLinkOf(RoverLink::kArm), arm_rad);
  if (!std::isfinite(rover.arm_lower_rad) && !std::isfinite(rover.arm_upper_rad)) return;
  world.Limit(Place(RoverLink::kArm), {.low_rad = rover.arm_lower_rad,
                                       .high_rad = rover.arm_upper_rad,
                                       .stop_nm_per_rad = rover.arm_stop_nm_per_rad,
                                       .stop_nms_per_rad = rover.arm_stop_nms_per_rad});
}

}  // namespace dockyard::axel
