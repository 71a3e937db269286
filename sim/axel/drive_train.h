// The rover's four motors on their shafts: wheels and arm on the rover's hinges, the spool on a
// drum of its own.
//
// The drum turns about the body's y axis at the axle and the tether leaves it below the axle,
// towards the tip (assumed: the drawings show no more than a drum in the body). Reeling in turns it
// about +y. The tether's pull therefore turns the arm tip-down against the body with torque
// T * drum_radius, and by virtual work turning the arm tip-down by dq gives drum_radius * dq of
// tether. The drum may grow with every turn that is wound on, as by layers of tether.
//
// The arm's root may go round the drum any number of turns: each gives 2 pi drum_radius of tether,
// or takes it, with the drum at rest.
#pragma once

#include <array>
#include <cstdint>

#include "controller/io/commands.h"
#include "models/axel/axel_model.h"
#include "sim/axel/rover_body.h"
#include "sim/drives/motor_drive.h"

namespace dockyard::axel {

class DriveTrain {
 public:
  DriveTrain(const RoverModel& rover, double arm_rad);

  /// Works the drives for one step under the tether's tension, adds their torques and reactions to
  /// the rover's loads, and turns the drum.
  void Step(const std::array<MotorCommand, kMotorCount>& commands, double tension_n, double dt_s,
            RoverBody& rover);

  /// Makes all shafts' present angles zero: power-on.
  void PowerOn(const RoverBody& rover);

  /// Angles since power-on, signs as SensorFrame::encoder_counts.
  double angle_rad(Motor motor, const RoverBody& rover) const;
  double speed_rad_s(Motor motor, const RoverBody& rover) const;
  const DriveOutput& output(Motor motor) const { return output_[static_cast<int>(motor)]; }
  /// Unstretched tether given out since power-on [m], and its rate.
  double tether_given_m(const RoverBody& rover) const;
  double tether_rate_m_s(const RoverBody& rover) const;
  /// Whether neither the drum nor a profile turns faster than this.
  bool IsStill(double rad_s, double dt_s) const;
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  /// Tether wound on since power-on, as an angle of the drum against the arm's guide [rad].
  double wound_rad(const RoverBody& rover) const {
    return drum_rad_ - angle_rad(Motor::kArm, rover);
  }
  /// Of the layer on which the tether winds now [m].
  double drum_radius_m(const RoverBody& rover) const {
    return drum_radius_m_ + drum_growth_m_per_rad_ * wound_rad(rover);
  }

  double drum_radius_m_ = 0.0, drum_growth_m_per_rad_ = 0.0, drum_inertia_kg_m2_ = 0.0;
  std::array<MotorDrive, kMotorCount> drives_;
  std::array<double, kMotorCount> zero_rad_{};  // joint angles at power-on
  std::array<DriveOutput, kMotorCount> output_{};
  double drum_rad_ = 0.0, drum_rad_s_ = 0.0;
};

}  // namespace dockyard::axel
