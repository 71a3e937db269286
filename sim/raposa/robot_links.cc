#include "sim/raposa/robot_links.h"

#include "sim/raposa/mating_shapes.h"

namespace dockyard::raposa {
namespace {

double RotorOf(const RobotModel& robot, Motor motor) {
  return robot.motors[static_cast<std::size_t>(motor)].reflected_inertia_kg_m2;
}

}  // namespace

std::vector<TreeLink> RobotLinks(const RobotModel& robot) {
  std::vector<TreeLink> links(kRobotLinkCount);
  links[kBody].model = robot.body;
  links[kArm] = {.model = robot.arm,
                 .parent = kBody,
                 .p_PL = robot.p_R_arm,
                 .rotor_kg_m2 = RotorOf(robot, Motor::kArm)};
  const double radius_m = robot.doors.pinion_radius_m;
  for (const RobotLink door : {kLeftDoor, kRightDoor}) {
    const bool left = door == kLeftDoor;
    const double rotor_kg_m2 = RotorOf(robot, left ? Motor::kLeftDoor : Motor::kRightDoor);
    links[door] = {.model = left ? robot.left_door : robot.right_door,
                   .parent = kBody,
                   .p_PL = robot.p_R_doors,
                   .rotor_kg_m2 = rotor_kg_m2 / (radius_m * radius_m),  // at the rack [kg]
                   .joint = JointKind::kSlide};
  }
  return links;
}

TreeBody MakeRobot(const RobotModel& robot, const Pose3& X_GR) {
  TreeBody body(RobotLinks(robot), {}, X_GR);
  body.SetAngle(kLeftDoor, robot.doors.travel_m);
  body.SetAngle(kRightDoor, -robot.doors.travel_m);
  return body;
}

std::vector<Collision> PiecesOf(const RobotModel& robot, RobotLink link) {
  if (link == kBody) return robot.body.collisions;
  if (link == kArm) return robot.arm.collisions;
  return DoorPieces(robot.doors, link == kLeftDoor);
}

}  // namespace dockyard::raposa
