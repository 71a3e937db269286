// The rover among the world's bodies: a tree of the body with two wheels and the arm on hinges
// about y, and of its further links. A motor's rotor counts with its joint.
#pragma once

#include <vector>

#include "models/axel/axel_model.h"
#include "sim/rigid/rigid_world.h"
#include "sim/vehicles/jointed_links.h"
#include "sim/vehicles/own_contacts.h"

namespace dockyard::axel {

/// The rover's own links; kFirstFurther and the numbers after it are its further ones.
enum class RoverLink : int { kBody, kLeftWheel, kRightWheel, kArm, kFirstFurther };
inline constexpr int kOwnLinkCount = static_cast<int>(RoverLink::kFirstFurther);
/// Of all links.
inline int LinkCount(const RoverModel& rover) {
  return kOwnLinkCount + static_cast<int>(rover.further.links.size());
}

/// The model of one link.
const LinkModel& LinkOf(const RoverModel& rover, RoverLink link);

/// Its tree, and where each link is in it. right_first: order of the wheels among them.
struct RoverTree {
  std::vector<TreeLink> links;
  TreePlaces places;  // by RoverLink
};
RoverTree TreeOf(const RoverModel& rover, bool right_first);

/// What each link shows to the rover's further links, by RoverLink.
std::vector<LinkParts> PartsOf(const RoverModel& rover);

class RoverBody {
 public:
  /// Adds it to the world, which must outlive it.
  RoverBody(RigidWorld& world, const RoverModel& rover, const Pose3& X_GR, double arm_rad,
            bool right_first);

  /// Its tree, and a link's place in the world.
  TreeBody& tree() { return world_.body(body_); }
  const TreeBody& tree() const { return world_.body(body_); }
  BodyLink Place(RoverLink link) const { return {body_, TreeLinkOf(link)}; }
  const TreePlaces& places() const { return tree_link_; }
  int link_count() const { return static_cast<int>(tree_link_.size()); }

  const LinkMotion& motion(RoverLink link) const { return tree().motion(TreeLinkOf(link)); }
  double joint_rad(RoverLink link) const { return tree().angle_rad(TreeLinkOf(link)); }
  double joint_rad_s(RoverLink link) const { return tree().rate_rad_s(TreeLinkOf(link)); }
  Eigen::Vector3d CentreOfMass(RoverLink link) const {
    return motion(link).X_GL * tree().link(TreeLinkOf(link)).model.p_LoCom_L;
  }

  /// The motors of further links.
  JointDrives& further_drives() { return further_drives_; }
  const JointDrives& further_drives() const { return further_drives_; }

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
  TreePlaces tree_link_;  // by RoverLink
  JointDrives further_drives_;
};

}  // namespace dockyard::axel
