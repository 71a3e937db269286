// The physical world of one run: rover, station, tether and soil under steps of 1 ms. Every run
// makes a new world and never resets it, so runs are repeatable.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "sim/axel/world_setup.h"
#include "sim/drives/imu.h"

namespace dockyard::axel {

/// A link as it moves, in W.
struct MovingLink {
  Pose3 X_WL;
  Eigen::Vector3d v_WL_W{0, 0, 0}, w_WL_W{0, 0, 0};  // of its origin
};

/// What is true now, for scoring, plots and drawing. Never handed to a controller.
struct Truth {
  double time_s = 0.0;
  Pose3 X_WR, X_WA, X_W_left_wheel, X_W_right_wheel, X_WS;  // body, arm, wheels, station
  std::vector<MovingLink> further;
  Eigen::Vector3d v_WR_W = Eigen::Vector3d::Zero(), w_WR_W = Eigen::Vector3d::Zero();
  Pose3 X_DR;  // rover in the dock frame carried by the station where it is now
  Eigen::Vector3d p_MT = Eigen::Vector3d::Zero();  // arm tip in the mouth frame M: -x is depth
  Eigen::Vector3d v_MT = Eigen::Vector3d::Zero();  // its velocity there [m/s]
  double arm_rad = 0.0, arm_rate_rad_s = 0.0;      // joint, tip-down positive
  std::array<double, kMotorCount> motor_angle_rad{}, motor_speed_rad_s{}, motor_torque_nm{},
      motor_current_a{},                  // current as drawn, without reading noise
      motor_lead_rad{};                   // of the encoder before the output
  double tether_tension_n = 0.0;          // at the arm's tip
  double tether_path_m = 0.0;             // arm tip to anchor, round the bends
  double tether_free_m = 0.0;             // unstretched length paid out
  std::vector<Eigen::Vector3d> tether_W;  // bends of the path, arm tip first, anchor last
  double cone_force_n = 0.0;  // magnitude of the sum of contact forces of cone and face on the arm
  double cone_force_peak_n = 0.0;  // largest of all steps until now
  double face_force_n = 0.0;       // part of the force now, on the annular face
  double tip_ground_force_n = 0.0;
  // Horizontal distance of the mouth from its place at the start, up to the judge's shake; and the
  // distance from there under the shake.
  double station_shift_m = 0.0, station_shake_m = 0.0;
  double station_sunk_m = 0.0;                         // the deepest foot's; 0 for hard feet
  double rock_force_n = 0.0, rock_force_peak_n = 0.0;  // all rocks' on the rover, now and until now
  double left_sinkage_m = 0.0, right_sinkage_m = 0.0;
  double left_wheel_load_n = 0.0, right_wheel_load_n = 0.0;  // the soil's, along z of the site
};

class World {
 public:
  explicit World(const WorldSetup& setup);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// One step with the drives obeying these commands (held until changed).
  void Step(const std::array<MotorCommand, kMotorCount>& commands);

  Tick tick() const;
  /// Whether nothing moves and no step is computed until a command changes.
  bool at_rest() const;
  /// Computed on demand; cheap enough for every control period, not for every step.
  Truth truth() const;
  const HeightGrid& ground() const;
  /// Specific force and body rate averaged over the steps since the last call, in R.
  TrueImu TakeTrueImu();
  /// Bit-exact fingerprint of all bodies, joints, drives, tether and soil contact.
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dockyard::axel
