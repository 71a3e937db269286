// The robot's belts with their motors: two sprockets, each drives the main belt and the arm's belt
// of its side.
//
// The drive sees its speed through an analog reading that is off and drifts. It holds the speed
// that it reads, so the belt runs beside what was asked, and the counts beside what the belt ran.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "controller/io/commands.h"
#include "models/parts/belt.h"
#include "models/raposa/ground_model.h"
#include "models/raposa/robot_model.h"
#include "sim/base/random.h"
#include "sim/drives/motor_drive.h"
#include "sim/raposa/robot_links.h"
#include "sim/vehicles/belt.h"

namespace dockyard::raposa {

/// One of the robot's main belts, its middle at y in R.
BeltModel BodyBeltOf(const RobotModel& robot, double y_m);
/// On these grounds, by their numbers.
Belt BeltOn(const std::vector<GroundModel>& grounds, const BeltModel& model);

enum class Side : std::uint8_t { kLeft, kRight };

class Tracks {
 public:
  /// Draws the readings' errors and the ground's scatter from the run's seed; the first ground's
  /// scatter holds on all. On soil the ground's strength is the soil's.
  Tracks(const RobotModel& robot, const std::vector<GroundModel>& grounds, const Seed& seed);

  /// Works one step under these commands to left and right, and adds the ground's loads to the
  /// robot.
  void Step(const HeightGrid& ground, const std::array<MotorCommand, 2>& commands, double dt_s,
            TreeBody& robot);

  /// Makes the present angles zero: power-on.
  void PowerOn() { read_rad_ = {}; }
  /// As the encoder reads it, since power-on.
  double read_rad(Side side) const { return read_rad_[Index(side)]; }
  double speed_rad_s(Side side) const { return speed_rad_s_[Index(side)]; }  // true
  const DriveOutput& output(Side side) const { return output_[Index(side)]; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  static std::size_t Index(Side side) { return static_cast<std::size_t>(side); }
  MotorCommand Obeyed(const MotorCommand& command, std::size_t side) const;
  void Wander(double dt_s);

  double radius_m_, inertia_kg_m2_, offset_rad_s_, drift_time_s_, dead_band_rad_s_;
  RandomStream drift_;
  std::array<MotorDrive, 2> drives_;
  std::array<Belt, 2> body_belts_, arm_belts_;
  std::array<double, 2> read_rad_{}, angle_rad_{}, speed_rad_s_{}, error_rad_s_{};
  std::array<DriveOutput, 2> output_{};
};

}  // namespace dockyard::raposa
