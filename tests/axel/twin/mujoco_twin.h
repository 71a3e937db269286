// A second model of the rover, in MuJoCo: the same masses, joints, rotors, drives and tether, but
// rigid smooth wheels on a rigid plane and another engine's dynamics and contacts. For tests and
// the benchmark only; it shares only the models and the motors' drives (no Bullet, no soil).
#pragma once

#include <array>

#include "sim/axel/world.h"
#include "sim/drives/motor_drive.h"
#include "support/mujoco_model.h"

namespace dockyard::axel {

/// What the twin meets beside the plane: for speeds, not compared with our world.
struct TwinSurroundings {
  bool uneven = false;  // the setup's heights, as a height field, in the plane's place
  bool cone = false;    // cone and arm as convex hulls
};

class MujocoTwin {
 public:
  /// ground_friction: Coulomb, of wheels on the ground, and of arm on cone. The station stands fast
  /// and must be reached by the tether without a bend. Without gravity there is no ground either.
  MujocoTwin(const WorldSetup& setup, double ground_friction, double gravity_m_s2,
             const TwinSurroundings& surroundings = {});

  void Step(const std::array<MotorCommand, kMotorCount>& commands);
  /// The same without drives and tether: torques on the three hinges.
  void StepUnder(const std::array<double, 3>& joint_torque_nm);

  void SetPose(const Pose3& X_GR, double arm_rad);
  Pose3 X_GR() const;
  Eigen::Vector3d w_GR_R() const;
  /// Left wheel, right wheel, arm.
  double joint_rad(int joint) const { return data_->qpos[7 + joint]; }
  double joint_rad_s(int joint) const { return data_->qvel[6 + joint]; }
  double spool_rad() const { return drum_rad_; }
  double tension_n() const { return tension_n_; }
  /// Contact forces of the wheels on the plane, in G [N].
  Eigen::Vector3d GroundForce() const;
  /// Whether the cone presses on the arm.
  bool ConePresses() const;
  Eigen::Vector3d TipInG() const;

  /// Ties the tether with this slack, drums and drives at their zeros.
  void PowerOn(double slack_m);

 private:
  void Pull();

  MujocoModel model_;
  MujocoData data_;
  RoverModel rover_;
  Eigen::Vector3d anchor_G_;
  std::array<MotorDrive, kMotorCount> drives_;
  std::array<double, 3> zero_rad_{};
  int body_ = 0, arm_ = 0, cone_ = -1;
  double drum_rad_ = 0.0, drum_rad_s_ = 0.0, free_at_start_m_ = 1e9, tension_n_ = 0.0;
};

}  // namespace dockyard::axel
