// The physical world of one run: robot, pyramid with its cable, and ground. Every run makes a new
// world and never resets it. No Bullet type appears in this header.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "controller/io/commands.h"
#include "models/raposa/ground_model.h"
#include "models/raposa/pyramid_model.h"
#include "models/raposa/robot_model.h"
#include "sim/base/random.h"
#include "sim/drives/imu.h"
#include "sim/drives/motor_truth.h"
#include "sim/rigid/slope.h"
#include "sim/soil/height_grid.h"

namespace dockyard::raposa {

struct WorldSetup {
  RobotModel robot;
  PyramidModel pyramid;
  std::vector<GroundModel> grounds{
      1};             // by the ground's numbers; soils that belts and feet sink into
  HeightGrid ground;  // in the site frame G
  Pose2 X_WG;         // site in the world, before it is tilted
  Slope slope;
  Pose2 X_GD;  // the pyramid: D is its frame P projected to the ground
  double cable_rad =
      0.0;           // the way to the cable's far end, off the one straight behind the pyramid
  Pose2 X_DV_start;  // the camera in plan, x along its view: towards the pyramid
  Seed seed;         // of the belts' readings
  double step_s = 1e-3;
  // Search for contacts in each step, also where robot and pyramid are apart: the slow way, for
  // tests of the fast one.
  bool search_always = false;
};

/// What is true now, for scoring, plots and drawing. Never handed to a controller.
struct Truth {
  double time_s = 0.0;
  Pose3 X_WR, X_WA, X_W_left_door, X_W_right_door, X_WP;  // body, arm, doors, pyramid
  Eigen::Vector3d v_WR_W = Eigen::Vector3d::Zero(), w_WR_W = Eigen::Vector3d::Zero();
  Pose3 X_DR_start;        // the body in D, which stays where the pyramid was at the start
  Pose3 X_PR;              // the body in the pyramid's frame where it is now
  double range_m = 0.0;    // camera to guide in plan
  double alpha_rad = 0.0;  // the camera's place about the pyramid's axis
  // The guide's middle from the socket's seat, in R: x < 0 is outside of it.
  Eigen::Vector3d p_SP_R = Eigen::Vector3d::Zero();
  double arm_rad = 0.0;
  double left_door_m = 0.0, right_door_m = 0.0;  // from closed, >= 0
  std::array<MotorTruth, kMotorCount> motors{};
  double contact_n = 0.0;       // sum of the forces between robot and pyramid
  double contact_peak_n = 0.0;  // of all steps until now
  double pyramid_shift_m = 0.0, pyramid_turn_rad = 0.0, pyramid_tilt_rad = 0.0;  // from the start
  double cable_pull_n = 0.0;
  std::vector<Eigen::Vector3d> cable_W;
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
  Truth truth() const;
  /// Without errors; averages since the last call. At the body's middle where it has no unit.
  TrueImu TakeTrueImu();
  const HeightGrid& ground() const;
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace dockyard::raposa
