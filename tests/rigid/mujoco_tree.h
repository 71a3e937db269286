// A tree of links as MuJoCo computes it.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/rigid/tree_body.h"
#include "support/mujoco_model.h"

namespace dockyard {

/// The same links, joints, rotors and dampers. A free base's frame is at its centre of mass, so
/// that its velocity is the one that TreeBody's speeds have.
class MujocoTree {
 public:
  struct Setup {
    double step_s = 1e-3;
    Eigen::Vector3d gravity_G{0, 0, 0};
    std::string integrator = "Euler";  // semi-implicit, or RK4
  };
  MujocoTree(const std::vector<TreeLink>& links, TreeBase base, const Setup& setup);

  /// Places, angles and speeds of `body`, which has the same links.
  void Take(const TreeBody& body);
  /// Loads of the next step; Take or Step comes before.
  void AddForce(int i, const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G);
  void AddTorque(int i, const Eigen::Vector3d& torque_G);
  void AddJointTorque(int i, double torque_nm);
  void Step();

  double angle_rad(int i) const { return data_->qpos[model_->jnt_qposadr[JointOf(i)]]; }
  Pose3 X_GB() const;
  /// In TreeBody's order and axes.
  TreeBody::Speeds speeds() const;
  TreeBody::Inertia MassMatrix() const;

 private:
  static std::string Name(int i) { return "l" + std::to_string(i); }
  int JointOf(int i) const { return mj_name2id(model_.get(), mjOBJ_JOINT, Name(i).c_str()); }
  int BodyOf(int i) const { return mj_name2id(model_.get(), mjOBJ_BODY, Name(i).c_str()); }
  std::string BodyText(int i) const;
  std::string JointText(int i) const;
  std::string Mjcf(const Setup& setup) const;
  /// Our speeds in its order: turning of a free base is in the base's axes there.
  Eigen::MatrixXd FromOurs() const;

  std::vector<TreeLink> links_;
  bool free_;
  MujocoModel model_;
  MujocoData data_;
};

}  // namespace dockyard
