// An arm of two joints with two scoops about one axis at its end.
//
// Joints, each with a motor, in this order: shoulder roll about the body's x, shoulder pitch about
// the y axis behind it, front scoop and back scoop, both about the y axis at the arm's end. At
// angle 0 the arm points straight ahead and level, its frame parallel to the body's. A positive
// pitch lowers the arm's end. At angle 0 the scoops' lips are below their axis, along -z of the
// arm, and a positive angle moves a lip backwards, towards the shoulder. So with the arm pitched
// down by p, scoops at -p have their lips straight down; the pair is open by the back scoop's angle
// less the front scoop's.
#pragma once

#include <cmath>
#include <cstdint>

#include "controller/geometry/pose.h"
#include "models/parts/joint_stop.h"
#include "models/parts/motor.h"

namespace dockyard {

/// Whether plates close a scoop's ends along its axis.
enum class ScoopSides : std::uint8_t { kClosed, kOpen };

/// One of two alike, each the other's mirror image. A trough of flat plates; parts/scoop_shape.h.
struct ScoopModel {
  double width_m = 0.0;    // along the axis
  double depth_m = 0.0;    // from the axis to the lip
  double belly_m = 0.0;    // how far the back stands off the mouth, the plane of axis and lip
  double wall_m = 0.0;     // thickness of the plates
  double opening_m = 0.0;  // between the lips, at most
  double mass_kg = 0.0;
  ScoopSides sides = ScoopSides::kClosed;
  JointStop stop;  // of a scoop's joint, and of the lips on each other
};

struct ArmModel {
  Eigen::Vector3d p_RA{0, 0, 0};  // of the shoulder in the body, z from the axles [m]
  double length_m = 0.0;          // from shoulder to scoops' axis
  double mass_kg = 0.0;           // without scoops
  double roll_stop_rad = 0.0;     // either way
  double pitch_low_rad = 0.0, pitch_high_rad = 0.0;
  double scoop_low_rad = 0.0, scoop_high_rad = 0.0;  // of each scoop against the arm
  double stowed_pitch_rad = 0.0;  // at the start; roll is 0, the scoops are closed, at
  double stowed_scoop_rad = 0.0;  // this angle
  JointStop stop;                 // of both joints of the shoulder
  ScoopModel scoop;
  MotorModel roll, pitch, scoop_motor;
};

/// Angle of the back scoop less that of the front one when the lips are furthest apart.
inline double MostOpen_rad(const ScoopModel& scoop) {
  return 2.0 * std::asin(0.5 * scoop.opening_m / scoop.depth_m);
}

/// The arm's motors, counted from its first.
inline constexpr int kArmRoll = 0, kArmPitch = 1, kFrontScoop = 2, kBackScoop = 3, kArmMotors = 4;

}  // namespace dockyard
