// Dead reckoning from the two belts: eqs. (8) and (9) of Ferreira and Ventura.
//
// Frame N, in this folder: the robot as it approaches, R turned half round about z. Its x axis
// points out of the back, towards a pyramid ahead of the back camera. O: N at the last reset.
#pragma once

#include <optional>

#include "controller/geometry/pose.h"
#include "controller/motion/path_follower.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// Of the motor's shaft since power-on.
double MotorAngle(const Nominal& nominal, const SensorFrame& sensed, Motor motor);

/// Motion between two readings.
struct BeltMotion {
  double length_m = 0.0;  // along x_N
  double turn_rad = 0.0;  // counter-clockwise from above
};

/// (8) and (9) with the sprockets' turns in place of their speeds, and one constant gauge d: "it
/// was empirically estimated and considered a constant" (F, E).
BeltMotion MotionOfBelts(const Nominal& nominal, double left_rad, double right_rad);

/// The sprockets' speeds that (8) and (9) give for a twist in N.
struct BeltSpeeds {
  double left_rad_s = 0.0,
         right_rad_s = 0.0;  // counting up drives towards the arm, along -x_N
};
BeltSpeeds SpeedsOfBelts(const Nominal& nominal, const Twist& twist_N);

class BeltOdometry {
 public:
  explicit BeltOdometry(const Nominal& nominal) : nominal_(nominal) {}
  /// Adds the motion since the last reading, and returns it; none at the first.
  BeltMotion Update(const SensorFrame& sensed);
  /// "The origin is reset after the end of state 7 with the angle rotated in that state" (F, D).
  void Reset(double turned_rad) { X_ON_ = {0.0, 0.0, turned_rad}; }
  const Pose2& X_ON() const { return X_ON_; }

 private:
  Nominal nominal_;
  Pose2 X_ON_;
  struct Angles {
    double left_rad = 0.0, right_rad = 0.0;
  };
  std::optional<Angles> last_;
};

}  // namespace dockyard::raposa
