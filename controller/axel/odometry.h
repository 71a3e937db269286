// Dead reckoning: distance from the wheels' encoder counts, direction from the inertial unit's yaw.
#pragma once

#include <optional>

#include "controller/axel/ground_slope.h"
#include "controller/axel/nominal/nominal.h"
#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

/// Output-shaft angle of a motor since power-on [rad].
double MotorAngle(const Nominal& nominal, const SensorFrame& sensed, Motor motor);
/// Angle of the arm against the body, tip-down positive [rad].
double ArmAngle(const Nominal& nominal, const SensorFrame& sensed);
/// Motion between two readings. The wheels' encoders count against the body, so a body that pitches
/// by p turns them by -p without rolling; Odometer adds p back. It does not remove wheel slip: the
/// pose filter allows for it. Pitch and turn are against the ground.
struct Motion {
  double length_m = 0.0;  // along the heading
  double turn_rad = 0.0;
  double lean_m = 0.0;          // to the left: a rover that leans over carries its axle along
  double wheel_turn_rad = 0.0;  // what the wheels' difference would turn it without slip
  bool operator==(const Motion&) const = default;
};

class Odometer {
 public:
  explicit Odometer(const Nominal& nominal) : nominal_(nominal) {}
  /// Motion since the last call; none at the first. heading_rad: in D, at the last call.
  Motion Read(const SensorFrame& sensed, const GroundSlope& ground, double heading_rad);

 private:
  Nominal nominal_;
  struct Last {
    double left_rad = 0.0, right_rad = 0.0;
    ImuSample imu;
  };
  std::optional<Last> last_;
};

}  // namespace dockyard::axel
