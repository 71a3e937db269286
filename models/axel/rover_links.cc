#include "models/axel/rover_links.h"

#include <cmath>
#include <utility>

#include "models/parts/collision_reach.h"
#include "models/read/config_error.h"
#include "models/read/urdf_weld.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {
namespace {

[[noreturn]] void RefuseJoint(const UrdfJoint& joint, const std::string& expected,
                              const std::string& found) {
  throw ConfigError(joint.place + ": expected " + expected + ", found '" + found + "'");
}

void CheckType(const UrdfJoint& joint, const char* type) {
  if (joint.type != type) RefuseJoint(joint, std::string("type ") + type, joint.type);
}

void CheckJoint(const UrdfJoint& joint, const char* child) {
  if (joint.parent != "body") RefuseJoint(joint, "parent body", joint.parent);
  if (joint.child != child) RefuseJoint(joint, std::string("child ") + child, joint.child);
  if (joint.axis_J != Eigen::Vector3d::UnitY()) RefuseJoint(joint, "axis 0 1 0", "another axis");
  if (!joint.X_PJ.R.isIdentity(1e-9)) {
    RefuseJoint(joint, "an origin without rotation", "a rotation");
  }
}

/// The model with fixed links welded.
UrdfModel WeldRover(const UrdfModel& urdf) {
  if (urdf.root != "body") {
    throw ConfigError(urdf.PlaceOf(urdf.root) + ": expected the root link to be 'body'");
  }
  for (const char* wheel : {"left_wheel_joint", "right_wheel_joint"}) {
    CheckType(urdf.Joint(wheel), "continuous");
  }
  // Axel's arm turns without limits. Another rover's may have end stops.
  const UrdfJoint& arm = urdf.Joint("arm_joint");
  if (arm.type != "continuous" && arm.type != "revolute") {
    RefuseJoint(arm, "type continuous or revolute", arm.type);
  }
  return WeldFixedLinks(urdf);
}

}  // namespace

void CheckArm(const UrdfModel& urdf, const RoverModel& rover) {
  const double tip_middle = rover.arm_length_m - 0.5 * rover.tip.length_m;
  for (const Collision& part : rover.arm.collisions) {
    const bool is_tip = part.name == "tip" && std::holds_alternative<CylinderShape>(part.shape);
    const bool is_collar = part.name == "collar" && rover.collar.radius_m > 0.0;
    if (std::holds_alternative<HullShape>(part.shape)) {
      throw ConfigError(urdf.PlaceOf("arm") + ": collision '" + part.name +
                        "': expected a cylinder, sphere or box, found a mesh");
    }
    if (is_tip || is_collar || ReachAlongX(part) <= tip_middle) continue;
    throw ConfigError(urdf.PlaceOf("arm") + ": collision '" + part.name + "' reaches to x " +
                      NumberText(ReachAlongX(part)) + ", expected at most " +
                      NumberText(tip_middle) +
                      ", the middle of the tip (arm.length_m less half "
                      "of arm.tip_length_m)");
  }
}

void TakeRoverLinks(const UrdfModel& file, RoverModel& rover) {
  const UrdfModel urdf = WeldRover(file);
  rover.body = RequireInertial(urdf, "body");
  rover.left_wheel = RequireInertial(urdf, "left_wheel");
  rover.right_wheel = RequireInertial(urdf, "right_wheel");
  rover.arm = RequireInertial(urdf, "arm");
  const UrdfJoint &left = urdf.Joint("left_wheel_joint"), &right = urdf.Joint("right_wheel_joint"),
                  &arm = urdf.Joint("arm_joint");
  CheckJoint(left, "left_wheel");
  CheckJoint(right, "right_wheel");
  CheckJoint(arm, "arm");
  rover.p_R_left_wheel = left.X_PJ.p;
  rover.p_R_right_wheel = right.X_PJ.p;
  const Eigen::Vector3d middle = 0.5 * (left.X_PJ.p + right.X_PJ.p);
  const Eigen::Vector3d apart = left.X_PJ.p - right.X_PJ.p;
  if (!(apart.y() > 0.0) || std::hypot(apart.x(), apart.z()) > 1e-9 || middle.norm() > 1e-9) {
    throw ConfigError(left.place +
                      ": expected the wheels on one axle along y through the body's origin, the "
                      "left one at y > 0");
  }
  if (arm.X_PJ.p.norm() > 1e-9) {
    throw ConfigError(arm.place + ": expected origin 0 0 0, the middle of the axle");
  }
  if (arm.type == "continuous") return;
  rover.arm_lower_rad = arm.lower_rad;
  rover.arm_upper_rad = arm.upper_rad;
}

JointedLinks TakeFurtherLinks(const YamlReader& in, const UrdfModel& file,
                              const JointsFile& joints) {
  JointedLinks further =
      TakeJointedLinks(in, WeldFixedLinks(file),
                       {.links = {"body", "left_wheel", "right_wheel", "arm"},
                        .joints = {"left_wheel_joint", "right_wheel_joint", "arm_joint"}},
                       joints);
  // Logs have bodies, frames and points by these names.
  for (const char* taken : {"robot", "station", "rocks", "scenery", "shade", "tether", "world",
                            "dock", "ground", "left", "right", "target", "tip", "board"}) {
    for (const JointedLink& each : further.links) {
      if (each.link.name != taken) continue;
      throw ConfigError(file.PlaceOf(taken) + ": expected another name than '" + taken +
                        "', which something else has in the logs");
    }
  }
  return further;
}

}  // namespace dockyard::axel
