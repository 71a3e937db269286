#include "sim/axel/rover_start.h"

#include <algorithm>
#include <cmath>

#include "sim/axel/cone_shapes.h"
#include "sim/axel/rock_contacts.h"

namespace dockyard::axel {
namespace {

// A wheel is put down from this much above the ground: higher than any rock's top with it [m].
constexpr double kAbove_m = 1.5;
constexpr int kHalvings = 30;
// The axle's roll decides where over the rock a wheel is, which decides the roll.
constexpr int kRolls = 4;
// Deeper than this in a rock, arm or body would be thrown off it [m].
constexpr double kInRock_m = 1e-3;
// Round parts count as polygons that hold them, 2 % wider [m].
constexpr double kInItself_m = 3e-3;
// Deeper than this in the ground a link would be thrown up: the wheels sink by some millimetres
// more. Assumed, range 10-30 mm [m].
constexpr double kInGround_m = 20e-3;

// Of a wheel with its axle along this pose's y: the lowest height of its centre above the ground
// and the rocks.
double StandingHeight(RockContacts& rocks, RoverLink link, Pose3 X_GK, double on_ground_m) {
  X_GK.p.z() = on_ground_m;
  if (rocks.Depth(link, X_GK) == 0.0) return on_ground_m;
  double low = on_ground_m, high = on_ground_m + kAbove_m;
  for (int i = 0; i < kHalvings; ++i) {
    X_GK.p.z() = 0.5 * (low + high);
    (rocks.Depth(link, X_GK) > 0.0 ? low : high) = X_GK.p.z();
  }
  return high;
}

Pose3 OnRocks(const WorldSetup& setup, const HeightGrid& ground, Pose3 X_GR) {
  RockContacts rocks(setup.rover, ArmCollisions(setup.rover), setup.rocks.rocks);
  const double heading = (setup.X_GD * setup.X_DR_start).heading;
  for (int i = 0; i < kRolls; ++i) {
    double at_m[2] = {0.0, 0.0};
    for (const bool left : {true, false}) {
      const Eigen::Vector3d& p = left ? setup.rover.p_R_left_wheel : setup.rover.p_R_right_wheel;
      const WheelModel& wheel = left ? setup.rover.left_wheel_soil : setup.rover.right_wheel_soil;
      const Pose3 X_GK{X_GR.R, X_GR * p};
      const double on_ground_m = ground.Height(X_GK.p.x(), X_GK.p.y()) + RollingRadius(wheel);
      at_m[left ? 1 : 0] = StandingHeight(
          rocks, left ? RoverLink::kLeftWheel : RoverLink::kRightWheel, X_GK, on_ground_m);
    }
    const Eigen::Vector3d across = setup.rover.p_R_left_wheel - setup.rover.p_R_right_wheel;
    const double roll = std::asin(std::clamp((at_m[1] - at_m[0]) / across.y(), -0.9, 0.9));
    X_GR.R = RotZ(heading) * RotX(roll) * RotY(setup.pitch_start_rad);
    X_GR.p.z() = 0.5 * (at_m[0] + at_m[1]) -
                 (X_GR.R * (0.5 * (setup.rover.p_R_left_wheel + setup.rover.p_R_right_wheel))).z();
  }
  return X_GR;
}

}  // namespace

Pose3 RoverStart(const WorldSetup& setup, const HeightGrid& ground) {
  const Pose2 X_GR = setup.X_GD * setup.X_DR_start;
  double z = -1e9;
  for (bool left : {true, false}) {
    const Eigen::Vector3d& p = left ? setup.rover.p_R_left_wheel : setup.rover.p_R_right_wheel;
    const WheelModel& wheel = left ? setup.rover.left_wheel_soil : setup.rover.right_wheel_soil;
    const Eigen::Vector2d at = X_GR * Eigen::Vector2d(p.x(), p.y());
    z = std::max(z, ground.Height(at.x(), at.y()) + RollingRadius(wheel) - p.z());
  }
  Pose3 level = FromGround(X_GR, z);
  level.R = level.R * RotY(setup.pitch_start_rad);
  if (setup.rocks.rocks.empty()) return level;
  RockContacts rocks(setup.rover, ArmCollisions(setup.rover), setup.rocks.rocks);
  const Pose3 X_GL{level.R, level * setup.rover.p_R_left_wheel};
  const Pose3 X_GQ{level.R, level * setup.rover.p_R_right_wheel};
  const bool clear = rocks.Depth(RoverLink::kLeftWheel, X_GL) == 0.0 &&
                     rocks.Depth(RoverLink::kRightWheel, X_GQ) == 0.0;
  return clear ? level : OnRocks(setup, ground, level);
}

std::string StartsInRock(const WorldSetup& setup) {
  if (setup.rocks.rocks.empty()) return "";
  RockContacts rocks(setup.rover, ArmCollisions(setup.rover), setup.rocks.rocks);
  RigidWorld world(Eigen::Vector3d::Zero());
  const RoverBody rover(world, setup.rover, RoverStart(setup, setup.ground), setup.arm_start_rad,
                        false);
  for (int i = 0; i < rover.link_count(); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    // Wheels were put on the rocks.
    if (link == RoverLink::kLeftWheel || link == RoverLink::kRightWheel) continue;
    if (rocks.Depth(link, rover.motion(link).X_GL) > kInRock_m)
      return LinkOf(setup.rover, link).name;
  }
  return "";
}

std::string StartsWrong(const WorldSetup& setup) {
  if (setup.rover.further.empty()) return "";
  RigidWorld world(Eigen::Vector3d::Zero());
  const RoverBody rover(world, setup.rover, RoverStart(setup, setup.ground), setup.arm_start_rad,
                        false);
  for (int i = kOwnLinkCount; i < rover.link_count(); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    const JointedLink& each =
        setup.rover.further.links[static_cast<std::size_t>(i - kOwnLinkCount)];
    const double angle_rad = rover.joint_rad(link);
    if (angle_rad < each.low_rad || angle_rad > each.high_rad) {
      return "'" + each.link.name + "' starts beyond its joint's limits";
    }
    for (const Collision& part : each.link.collisions) {
      for (const Eigen::Vector3d& p_L : SolidOf(part).vertices) {
        const Eigen::Vector3d p_G = rover.motion(link).X_GL * p_L;
        if (setup.ground.Height(p_G.x(), p_G.y()) - p_G.z() < kInGround_m) continue;
        return "'" + each.link.name + "' starts in the ground";
      }
    }
  }
  return "";
}

std::string StartsInItself(const RoverModel& rover, double arm_start_rad) {
  if (rover.further.empty()) return "";
  RigidWorld world(Eigen::Vector3d::Zero());
  const RoverBody body(world, rover, {}, arm_start_rad, false);
  OwnContacts contacts(world, body.Place(RoverLink::kBody).body, rover.further, body.places(),
                       PartsOf(rover));
  const auto links = contacts.FindOverlap(kInItself_m);
  if (!links) return "";
  const auto name = [&](int link) {
    return "'" + LinkOf(rover, static_cast<RoverLink>(link)).name + "'";
  };
  return name(links->first) + " and " + name(links->second);
}

}  // namespace dockyard::axel
