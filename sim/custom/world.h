// The physical world of one run: a robot, a dock and the ground. Every run makes a new world and
// never resets it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/custom/tree_in_world.h"
#include "sim/custom/truth.h"
#include "sim/custom/world_setup.h"
#include "sim/drives/imu.h"
#include "sim/drives/motor_drive.h"
#include "sim/soil/wheel_soil.h"
#include "sim/vehicles/tyres.h"

namespace dockyard::custom {

struct WorldContacts;  // world_contacts.h

class World {
 public:
  /// The robot is braked until it has come to rest. The step must be in (0, kLongestStep_s].
  explicit World(const WorldSetup& setup);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// One step with the drives obeying these commands, and a force on the robot's root [N].
  void Step(const std::vector<MotorCommand>& commands,
            const Eigen::Vector3d& push_G = Eigen::Vector3d::Zero());
  /// A force on the dock's root in the next step [N]; for tests.
  void PushDock(const Eigen::Vector3d& force_G);
  Tick tick() const { return std::llround(time_s() / kTickSeconds); }
  Truth truth() const;
  /// Averages since the last call.
  TrueImu TakeTrueImu();
  /// Of a link of the robot, in the world W in place of G.
  LinkMotion MotionInWorld(int link) const;
  const HeightGrid& ground() const { return setup_.ground.heights; }
  const Pose3& X_WG() const { return X_WG_; }
  /// How far solids of robot and dock reached into each other as they were put down; 0: not at all.
  double start_overlap_m() const { return start_overlap_m_; }
  /// How far the dock moved, and turned, as it came to rest where it was put down.
  double dock_settled_m() const { return dock_settled_m_; }
  double dock_settled_rad() const { return dock_settled_rad_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Motor {
    int link = 0;  // in the tree
    double travel_per_rad = 1.0;
    MotorDrive drive;
    DriveOutput output;
  };
  double time_s() const { return static_cast<double>(steps_) * setup_.step_s; }
  double OverlapNow() const;
  void AddMotors();
  void AddWheels();
  void Drive(const std::vector<MotorCommand>& commands);
  void LoadWheels();
  void RestDock();
  void FillContacts(Truth& truth) const;
  void FillWheels(Truth& truth) const;
  void FillDock(Truth& truth) const;

  WorldSetup setup_;
  Pose3 X_WG_;
  RigidWorld world_;
  TreeInWorld robot_, dock_;
  JointDrives robot_drives_, dock_drives_;  // of joints that no controller commands
  std::vector<Motor> motors_;
  std::optional<Tyres> tyres_;
  std::vector<WheelSoil> soils_;
  std::vector<WheelLoad> soil_loads_;
  std::unique_ptr<WorldContacts> contacts_;
  std::optional<ImuAverage> imu_;
  std::vector<LinkSolid> dock_solids_;
  Pose3 X_GD_start_;  // the dock as it was built
  double dock_still_s_ = 0.0;
  double start_overlap_m_ = 0.0, dock_settled_m_ = 0.0, dock_settled_rad_ = 0.0;
  double touch_n_ = 0.0, peak_touch_n_ = 0.0;
  long steps_ = 0;
};

}  // namespace dockyard::custom
