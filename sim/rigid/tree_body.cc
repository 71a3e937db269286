#include "sim/rigid/tree_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A link and all beyond it, about its centre: mass, first moment, inertia.
struct Composite {
  double mass = 0.0;
  Vector3d moment = Vector3d::Zero();
  Matrix3d inertia = Matrix3d::Zero();
};

// Of the same bodies about a point that lies -r from the composite's.
Composite Shifted(const Composite& at, const Vector3d& r) {
  const Matrix3d first = CrossMatrix(at.moment), arm = CrossMatrix(r);
  return {at.mass, at.moment + at.mass * r,
          at.inertia - first * arm - arm * first - at.mass * arm * arm};
}

}  // namespace

TreeBody::TreeBody(std::vector<TreeLink> links, std::vector<JointTie> ties, const Pose3& X_GB)
    : links_(std::move(links)), X_GB_(X_GB) {
  const std::size_t count = links_.size();
  DOCKYARD_CHECK(count > 0 && links_[0].parent == -1);
  if (count + 5 > kMostSpeeds) throw std::invalid_argument("a tree has too many links");
  for (std::size_t i = 0; i < count; ++i) {
    DOCKYARD_CHECK(links_[i].model.mass_kg > 0.0);
    DOCKYARD_CHECK(i == 0 || (links_[i].parent >= 0 && Place(links_[i].parent) < i));
    mass_kg_ += links_[i].model.mass_kg;
  }
  const auto speeds = static_cast<Eigen::Index>(count + 5);
  motion_.resize(count);
  com_G_.resize(count);
  axis_G_.resize(count);
  inertia_G_.resize(count);
  angle_rad_.assign(count, 0.0);
  loads_.resize(count);
  joint_loads_nm_.assign(count, 0.0);
  speeds_.setZero(speeds);
  ties_.setZero(static_cast<Eigen::Index>(ties.size()), speeds);
  for (std::size_t row = 0; row < ties.size(); ++row) {
    for (const auto& [link, weight] : ties[row]) {
      DOCKYARD_CHECK(link > 0 && Place(link) < count);
      ties_(static_cast<Eigen::Index>(row), 5 + link) = weight;
    }
  }
  Refresh();
}

void TreeBody::SetAngle(int i, double angle_rad) {
  angle_rad_[Place(i)] = angle_rad;
  Refresh();
}

// Places, speeds and inertias of all links, from the base outwards.
void TreeBody::Refresh() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TreeLink& link = links_[i];
    LinkMotion& own = motion_[i];
    if (i == 0) {
      own.X_GL = X_GB_;
      own.w_GL_G = speeds_.segment<3>(3);
      own.v_GL_G = speeds_.head<3>() - own.w_GL_G.cross(X_GB_.R * link.model.p_LoCom_L);
    } else {
      const LinkMotion& parent = motion_[Place(link.parent)];
      axis_G_[i] = parent.X_GL.R * link.axis_L;
      own.X_GL.R = parent.X_GL.R * Eigen::AngleAxisd(angle_rad_[i], link.axis_L).toRotationMatrix();
      own.X_GL.p = parent.X_GL * link.p_PL;
      own.w_GL_G = parent.w_GL_G + speeds_[5 + static_cast<Eigen::Index>(i)] * axis_G_[i];
      own.v_GL_G = parent.VelocityAt(own.X_GL.p);
    }
    com_G_[i] = own.X_GL * link.model.p_LoCom_L;
    inertia_G_[i] = own.X_GL.R * link.model.I_LCom_L * own.X_GL.R.transpose();
  }
}

void TreeBody::AddForce(int i, const Vector3d& force_G, const Vector3d& p_G) {
  loads_[Place(i)].force += force_G;
  loads_[Place(i)].torque += (p_G - Centre(i)).cross(force_G);
}

void TreeBody::AddTorque(int i, const Vector3d& torque_G) { loads_[Place(i)].torque += torque_G; }

void TreeBody::AddJointTorque(int i, double torque_nm) { joint_loads_nm_[Place(i)] += torque_nm; }

// Loads less what the links' accelerations take that come of the speeds alone, over the speeds.
TreeBody::Speeds TreeBody::CollectLoads(const Vector3d& gravity_G) {
  std::vector<Wrench> all = loads_;
  std::vector<Vector3d> turning(links_.size(), Vector3d::Zero()), going = turning;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const LinkMotion& own = motion_[i];
    const Vector3d to_com = com_G_[i] - Centre(static_cast<int>(i));
    if (i > 0) {
      const std::size_t parent = Place(links_[i].parent);
      const Vector3d r = own.X_GL.p - Centre(links_[i].parent), w = motion_[parent].w_GL_G;
      going[i] = going[parent] + turning[parent].cross(r) + w.cross(w.cross(r));
      turning[i] = turning[parent] + w.cross(axis_G_[i]) * rate_rad_s(static_cast<int>(i));
    }
    const Vector3d& w = own.w_GL_G;
    const Vector3d acceleration = going[i] + turning[i].cross(to_com) + w.cross(w.cross(to_com));
    const Vector3d force = links_[i].model.mass_kg * (gravity_G - acceleration);
    all[i].force += force;
    all[i].torque += to_com.cross(force) - inertia_G_[i] * turning[i] - w.cross(inertia_G_[i] * w);
  }
  Speeds over_speeds = Speeds::Zero(speeds_.size());
  for (std::size_t i = links_.size() - 1; i > 0; --i) {
    over_speeds[5 + static_cast<Eigen::Index>(i)] =
        axis_G_[i].dot(all[i].torque) + joint_loads_nm_[i];
    const std::size_t parent = Place(links_[i].parent);
    const Vector3d r = motion_[i].X_GL.p - Centre(links_[i].parent);
    all[parent].force += all[i].force;
    all[parent].torque += all[i].torque + r.cross(all[i].force);
  }
  over_speeds.head<3>() = all[0].force;
  over_speeds.segment<3>(3) = all[0].torque;
  return over_speeds;
}

TreeBody::Inertia TreeBody::MassMatrix() const {
  const auto count = static_cast<int>(links_.size());
  std::vector<Composite> bodies(links_.size());
  for (int i = 0; i < count; ++i) {
    const double mass = links_[Place(i)].model.mass_kg;
    bodies[Place(i)] =
        Shifted({mass, Vector3d::Zero(), inertia_G_[Place(i)]}, com_G_[Place(i)] - Centre(i));
  }
  Inertia M = Inertia::Zero(speeds_.size(), speeds_.size());
  for (int i = count - 1; i > 0; --i) {
    const Vector3d& axis = axis_G_[Place(i)];
    const Composite& own = bodies[Place(i)];
    // Load that turning about this hinge alone takes, carried inwards.
    const Vector3d force = axis.cross(own.moment);
    Vector3d torque = own.inertia * axis;
    M(5 + i, 5 + i) = axis.dot(torque) + links_[Place(i)].rotor_kg_m2;
    for (int at = i; at != 0;) {
      const int parent = links_[Place(at)].parent;
      torque += (Centre(at) - Centre(parent)).cross(force);
      at = parent;
      if (at != 0) M(5 + i, 5 + at) = axis_G_[Place(at)].dot(torque);
    }
    M.row(5 + i).head<3>() = force;
    M.row(5 + i).segment<3>(3) = torque;
    const int parent = links_[Place(i)].parent;
    const Composite inwards = Shifted(own, Centre(i) - Centre(parent));
    Composite& onto = bodies[Place(parent)];
    onto.mass += inwards.mass;
    onto.moment += inwards.moment;
    onto.inertia += inwards.inertia;
  }
  M.topLeftCorner<3, 3>().diagonal().setConstant(bodies[0].mass);
  M.block<3, 3>(3, 0) = CrossMatrix(bodies[0].moment);
  M.block<3, 3>(3, 3) = bodies[0].inertia;
  M.triangularView<Eigen::StrictlyUpper>() = M.transpose();
  return M;
}

void TreeBody::FindAnswers() {
  mass_.compute(MassMatrix());
  if (ties_.rows() == 0) return;
  tie_answers_ = mass_.solve(ties_.transpose());
  held_.compute(ties_ * tie_answers_);
}

TreeBody::Speeds TreeBody::Answer(const Speeds& impulse) const {
  Speeds change = mass_.solve(impulse);
  if (ties_.rows() > 0) change -= tie_answers_ * held_.solve(ties_ * change);
  return change;
}

Eigen::MatrixXd TreeBody::Answers(const Eigen::MatrixXd& impulses) const {
  Eigen::MatrixXd changes = mass_.solve(impulses);
  if (ties_.rows() > 0) changes -= tie_answers_ * held_.solve(ties_ * changes);
  return changes;
}

void TreeBody::TakeLoads(const Vector3d& gravity_G, double step_s) {
  FindAnswers();
  AddSpeeds(Answer(step_s * CollectLoads(gravity_G)));
  for (Wrench& load : loads_) load = {};
  std::fill(joint_loads_nm_.begin(), joint_loads_nm_.end(), 0.0);
}

void TreeBody::AddSpeeds(const Speeds& change) {
  speeds_ += change;
  Refresh();
}

void TreeBody::Move(double step_s) {
  const Vector3d com_G = com_G_[0] + step_s * speeds_.head<3>();
  const Vector3d turn = step_s * speeds_.segment<3>(3);
  const double angle = turn.norm();
  if (angle > 0.0) {
    Eigen::Quaterniond q(Eigen::AngleAxisd(angle, turn / angle) * Eigen::Quaterniond(X_GB_.R));
    X_GB_.R = q.normalized().toRotationMatrix();
  }
  X_GB_.p = com_G - X_GB_.R * links_[0].model.p_LoCom_L;
  for (std::size_t i = 1; i < links_.size(); ++i) {
    angle_rad_[i] += step_s * speeds_[5 + static_cast<Eigen::Index>(i)];
  }
  Refresh();
}

TreeBody::PointJacobian TreeBody::JacobianOf(int i, const Vector3d& p_G) const {
  PointJacobian J = PointJacobian::Zero(3, speeds_.size());
  J.leftCols<3>().setIdentity();
  J.middleCols<3>(3) = -CrossMatrix(p_G - com_G_[0]);
  for (int at = i; at != 0; at = links_[Place(at)].parent) {
    J.col(5 + at) = axis_G_[Place(at)].cross(p_G - motion_[Place(at)].X_GL.p);
  }
  return J;
}

std::uint64_t TreeBody::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (int i = 0; i < 9; ++i) hash = HashDouble(hash, X_GB_.R(i));
  for (int i = 0; i < 3; ++i) hash = HashDouble(hash, X_GB_.p[i]);
  for (const double angle : angle_rad_) hash = HashDouble(hash, angle);
  for (const double speed : speeds_) hash = HashDouble(hash, speed);
  return hash;
}

}  // namespace dockyard
