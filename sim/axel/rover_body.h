// The rover among the world's bodies: a tree of the body with two wheels and the arm on hinges
// about y. A motor's rotor counts with its joint.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/axel/axel_model.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard::axel {

enum class RoverLink { kBody, kLeftWheel, kRightWheel, kArm };
inline constexpr int kRoverLinkCount = 4;

/// The model of one link.
const LinkModel& LinkOf(const RoverModel& rover, RoverLink link);

/// The links of its tree. right_first: order of the wheels among them.
std::vector<TreeLink> RoverLinks(const RoverModel& rover, bool right_first);

class RoverBody {
 public:
  /// Adds it to the world, which must outlive it.
  RoverBody(RigidWorld& world, const RoverModel& rover, const Pose3& X_GR, double arm_rad,
            bool right_first);

  /// Its tree, and a link's place in the world.
  TreeBody& tree() { return world_.body(body_); }
  const TreeBody& tree() const { return world_.body(body_); }
  BodyLink Place(RoverLink link) const { return {body_, TreeLinkOf(link)}; }

  const LinkMotion& motion(RoverLink link) const { return tree().motion(TreeLinkOf(link)); }
  double joint_rad(RoverLink link) const { return tree().angle_rad(TreeLinkOf(link)); }
  double joint_rad_s(RoverLink link) const { return tree().rate_rad_s(TreeLinkOf(link)); }
  Eigen::Vector3d CentreOfMass(RoverLink link) const {
    return motion(link).X_GL * tree().link(TreeLinkOf(link)).model.p_LoCom_L;
  }

  /// Loads of the next step, in G. A torque on a joint acts on the link, its opposite on the body.
  void AddForce(RoverLink link, const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G) {
    tree().AddForce(TreeLinkOf(link), force_G, p_G);
  }
  void AddTorque(RoverLink link, const Eigen::Vector3d& torque_G) {
    tree().AddTorque(TreeLinkOf(link), torque_G);
  }
  void AddJointTorque(RoverLink link, double torque_nm) {
    tree().AddJointTorque(TreeLinkOf(link), torque_nm);
  }

 private:
  int TreeLinkOf(RoverLink link) const { return tree_link_[static_cast<std::size_t>(link)]; }

  RigidWorld& world_;
  int body_ = 0;
  std::array<int, kRoverLinkCount> tree_link_{};  // by RoverLink
};

}  // namespace dockyard::axel
