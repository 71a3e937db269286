// A mast of three joints that carries an instrument and a stereo pair at its end.
//
// Joints, each with a motor, in this order: shoulder roll about the body's z, shoulder pitch about
// the y axis behind it, elbow pitch about the y axis at the first link's end. At angle 0 both links
// point straight ahead and level, their frames parallel to the body's. A positive roll turns to the
// left, a positive pitch lowers what hangs on the joint. The instrument's face is at the second
// link's end, and looks along it.
#pragma once

#include <array>

#include "controller/geometry/pose.h"
#include "models/parts/joint_stop.h"
#include "models/parts/motor.h"

namespace dockyard {

/// A can with contact switches on its face.
struct InstrumentModel {
  double radius_m = 0.0, length_m = 0.0;
  double mass_kg = 0.0;          // with the cameras beside it
  double switch_radius_m = 0.0;  // of the circle on which the switches are, 120 deg apart
  double switch_out_m = 0.0;     // how far they stand out of the face
  double closes_n = 0.0;         // force that closes a switch
  double switch_n_per_m = 0.0;   // of a switch's spring
  double rim_n_per_m = 0.0;      // of a point of the can's rim
  double mast_n_per_m = 0.0, mast_ns_per_m = 0.0;  // how the mast gives way along the tool's axis
  double friction = 0.0;
};

struct MastModel {
  Eigen::Vector3d p_RM{0, 0, 0};        // of the shoulder in the body, z from the axles [m]
  double link1_m = 0.0, link2_m = 0.0;  // shoulder to elbow; elbow to the switches' tips
  double housing_kg = 0.0;              // of the shoulder, which only rolls
  double link1_kg = 0.0, link2_kg = 0.0;
  // By joint, in the order above.
  std::array<double, 3> low_rad{}, high_rad{};
  std::array<double, 3> stowed_rad{}, watch_rad{};  // the latter: it looks ahead
  JointStop stop;                                   // of all joints
  InstrumentModel instrument;
  std::array<MotorModel, 3> motors{};

  double mass_kg() const { return housing_kg + link1_kg + link2_kg + instrument.mass_kg; }
};

/// The mast's motors, counted from its first.
inline constexpr int kMastRoll = 0, kMastShoulder = 1, kMastElbow = 2, kMastMotors = 3;

}  // namespace dockyard
