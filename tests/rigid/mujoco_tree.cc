#include "rigid/mujoco_tree.h"

#include <Eigen/Geometry>
#include <sstream>

namespace dockyard {
namespace {

using Eigen::Vector3d;

}  // namespace

MujocoTree::MujocoTree(const std::vector<TreeLink>& links, TreeBase base, const Setup& setup)
    : links_(links),
      free_(base == TreeBase::kFree),
      model_(LoadMujoco(Mjcf(setup))),
      data_(mj_makeData(model_.get())) {
  mj_forward(model_.get(), data_.get());
}

std::string MujocoTree::JointText(int i) const {
  const TreeLink& link = links_[static_cast<std::size_t>(i)];
  if (i == 0 && free_) return "<freejoint name=\"" + Name(0) + "\"/>\n";
  if (i == 0 || link.joint == JointKind::kFixed) return "";
  std::ostringstream out;
  out.precision(17);
  out << "<joint name=\"" << Name(i) << "\" type=\"" << (link.IsHinge() ? "hinge" : "slide")
      << "\" axis=\"" << MjcfNumbers(link.axis_L) << "\" armature=\"" << link.rotor_kg_m2
      << "\" damping=\"" << link.damping_nms_per_rad << "\"/>\n";
  return out.str();
}

std::string MujocoTree::BodyText(int i) const {
  const TreeLink& link = links_[static_cast<std::size_t>(i)];
  const Vector3d& base_com = links_[0].model.p_LoCom_L;
  LinkModel model = link.model;
  Vector3d p_PL = link.p_PL;
  if (i == 0) {
    p_PL = base_com;
    model.p_LoCom_L.setZero();
  } else if (link.parent == 0) {
    p_PL -= base_com;
  }
  const Eigen::Quaterniond turn(i == 0 ? Eigen::Matrix3d::Identity() : link.R_PL);
  std::ostringstream out;
  out.precision(17);
  out << "<body name=\"" << Name(i) << "\" pos=\"" << MjcfNumbers(p_PL) << "\" quat=\"" << turn.w()
      << ' ' << MjcfNumbers(turn.vec()) << "\">\n"
      << JointText(i) << MjcfInertial(model);
  for (int child = i + 1; child < static_cast<int>(links_.size()); ++child) {
    if (links_[static_cast<std::size_t>(child)].parent == i) out << BodyText(child);
  }
  out << "</body>\n";
  return out.str();
}

std::string MujocoTree::Mjcf(const Setup& setup) const {
  std::ostringstream out;
  out.precision(17);
  out << "<mujoco><compiler angle=\"radian\"/>\n<option timestep=\"" << setup.step_s
      << "\" gravity=\"" << MjcfNumbers(setup.gravity_G) << "\" integrator=\"" << setup.integrator
      << "\"/>\n<worldbody>\n"
      << BodyText(0) << "</worldbody></mujoco>\n";
  return out.str();
}

void MujocoTree::Take(const TreeBody& body) {
  if (free_) {
    const Pose3& X_GB = body.motion(0).X_GL;
    const Vector3d com_G = X_GB * links_[0].model.p_LoCom_L;
    const Eigen::Quaterniond turn(X_GB.R);
    for (int k = 0; k < 3; ++k) data_->qpos[k] = com_G[k];
    data_->qpos[3] = turn.w();
    for (int k = 0; k < 3; ++k) data_->qpos[4 + k] = turn.vec()[k];
  }
  for (int i = 1; i < body.link_count(); ++i) {
    if (body.SpeedOf(i) >= 0) data_->qpos[model_->jnt_qposadr[JointOf(i)]] = body.angle_rad(i);
  }
  mj_forward(model_.get(), data_.get());
  Eigen::Map<Eigen::VectorXd>(data_->qvel, model_->nv) = FromOurs() * body.speeds();
  mj_forward(model_.get(), data_.get());
}

void MujocoTree::AddForce(int i, const Vector3d& force_G, const Vector3d& p_G) {
  const Vector3d none = Vector3d::Zero();
  mj_applyFT(model_.get(), data_.get(), force_G.data(), none.data(), p_G.data(), BodyOf(i),
             data_->qfrc_applied);
}

void MujocoTree::AddTorque(int i, const Vector3d& torque_G) {
  const Vector3d none = Vector3d::Zero();
  mj_applyFT(model_.get(), data_.get(), none.data(), torque_G.data(), none.data(), BodyOf(i),
             data_->qfrc_applied);
}

void MujocoTree::AddJointTorque(int i, double torque_nm) {
  data_->qfrc_applied[model_->jnt_dofadr[JointOf(i)]] += torque_nm;
}

void MujocoTree::Step() {
  mj_step(model_.get(), data_.get());
  mju_zero(data_->qfrc_applied, model_->nv);
  mj_forward(model_.get(), data_.get());  // places of the new state, for the next loads
}

Pose3 MujocoTree::X_GB() const {
  const mjtNum* q = data_->qpos;
  Pose3 X_GB;
  X_GB.R = Eigen::Quaterniond(q[3], q[4], q[5], q[6]).toRotationMatrix();
  X_GB.p = Vector3d(q[0], q[1], q[2]) - X_GB.R * links_[0].model.p_LoCom_L;
  return X_GB;
}

Eigen::MatrixXd MujocoTree::FromOurs() const {
  Eigen::MatrixXd from = Eigen::MatrixXd::Zero(model_->nv, model_->nv);
  Eigen::Index ours = 0;
  if (free_) {
    from.topLeftCorner<3, 3>().setIdentity();
    from.block<3, 3>(3, 3) = X_GB().R.transpose();
    ours = 6;
  }
  for (int i = 1; i < static_cast<int>(links_.size()); ++i) {
    if (links_[static_cast<std::size_t>(i)].joint == JointKind::kFixed) continue;
    from(model_->jnt_dofadr[JointOf(i)], ours++) = 1.0;
  }
  return from;
}

TreeBody::Speeds MujocoTree::speeds() const {
  // Its columns are orthogonal unit vectors.
  return FromOurs().transpose() * Eigen::Map<const Eigen::VectorXd>(data_->qvel, model_->nv);
}

TreeBody::Inertia MujocoTree::MassMatrix() const {
  Eigen::MatrixXd M(model_->nv, model_->nv);
  mj_fullM(model_.get(), M.data(), data_->qM);
  const Eigen::MatrixXd from = FromOurs();
  return from.transpose() * M * from;
}

}  // namespace dockyard
