// RAPOSA's robot as an articulated body of Bullet's: a free body with the arm on a hinge and two
// doors on slides along y.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <array>
#include <cstdint>
#include <memory>

#include "models/raposa/robot_model.h"
#include "sim/rigid/collision_shapes.h"
#include "sim/rigid/inertia.h"
#include "sim/rigid/motion.h"

namespace dockyard::raposa {

enum class RobotLink { kBody, kArm, kLeftDoor, kRightDoor };
inline constexpr int kRobotLinkCount = 4;

class RobotBody {
 public:
  /// Doors open.
  RobotBody(const RobotModel& robot, const Pose3& X_GR, double arm_rad);
  RobotBody(const RobotBody&) = delete;
  RobotBody& operator=(const RobotBody&) = delete;

  const LinkMotion& motion(RobotLink link) const { return motion_[Index(link)]; }
  /// The arm's angle [rad], tip down positive; a door's place along y from closed [m].
  double joint(RobotLink link) const { return multibody_->getJointPos(Index(link) - 1); }
  double joint_rate(RobotLink link) const { return multibody_->getJointVel(Index(link) - 1); }

  /// Loads of the next step, in G; torque about the link's origin.
  void AddLoad(RobotLink link, const Eigen::Vector3d& force_G, const Eigen::Vector3d& torque_G);
  /// A torque [N m] or force [N] on a joint acts on the link, its opposite on the body.
  void AddJointLoad(RobotLink link, double load);

  /// Takes over positions and speeds after a step.
  void Refresh();
  btMultiBody* multibody() { return multibody_.get(); }
  btMultiBodyLinkCollider* collider(RobotLink link) { return colliders_[Index(link)].get(); }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  static int Index(RobotLink link) { return static_cast<int>(link); }
  void AddJoint(const RobotModel& robot, RobotLink link);
  void AddCollider(const RobotModel& robot, RobotLink link);

  std::array<Eigen::Vector3d, kRobotLinkCount> p_R_joint_;
  std::array<PrincipalInertia, kRobotLinkCount> inertia_;
  std::array<LinkShape, kRobotLinkCount> shapes_;
  std::unique_ptr<btMultiBody> multibody_;
  std::array<std::unique_ptr<btMultiBodyLinkCollider>, kRobotLinkCount> colliders_;
  std::array<LinkMotion, kRobotLinkCount> motion_;
};

}  // namespace dockyard::raposa
