// What a tree's speeds answer to impulses: composite inertia, ties, and velocities of points.
#include <array>

#include "sim/rigid/tree_body.h"

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

TreeBody::Inertia TreeBody::MassMatrix() const {
  const auto count = static_cast<int>(links_.size());
  std::array<Composite, kMostLinks> bodies;
  for (int i = 0; i < count; ++i) {
    const double mass = links_[Place(i)].model.mass_kg;
    bodies[Place(i)] =
        Shifted({mass, Vector3d::Zero(), inertia_G_[Place(i)]}, com_G_[Place(i)] - Centre(i));
  }
  Inertia M = Inertia::Zero(speeds_.size(), speeds_.size());
  for (int i = count - 1; i > 0; --i) {
    const Composite& own = bodies[Place(i)];
    if (SpeedOf(i) >= 0) {
      const Vector3d& axis = axis_G_[Place(i)];
      const Eigen::Index row = SpeedOf(i);
      // Load that a unit rate of this joint alone takes, carried inwards.
      Vector3d force =
          links_[Place(i)].IsHinge() ? Vector3d(axis.cross(own.moment)) : Vector3d(own.mass * axis);
      Vector3d torque = links_[Place(i)].IsHinge() ? Vector3d(own.inertia * axis)
                                                   : Vector3d(own.moment.cross(axis));
      M(row, row) = links_[Place(i)].Along(axis, force, torque) + links_[Place(i)].rotor_kg_m2;
      for (int at = i; at != 0;) {
        const int parent = links_[Place(at)].parent;
        torque += (Centre(at) - Centre(parent)).cross(force);
        at = parent;
        if (SpeedOf(at) >= 0)
          M(row, SpeedOf(at)) = links_[Place(at)].Along(axis_G_[Place(at)], force, torque);
      }
      if (rules_.base == TreeBase::kFree) {
        M.row(row).head<3>() = force;
        M.row(row).segment<3>(3) = torque;
      }
    }
    const int parent = links_[Place(i)].parent;
    const Composite inwards = Shifted(own, Centre(i) - Centre(parent));
    Composite& onto = bodies[Place(parent)];
    onto.mass += inwards.mass;
    onto.moment += inwards.moment;
    onto.inertia += inwards.inertia;
  }
  if (rules_.base == TreeBase::kFree) {
    M.topLeftCorner<3, 3>().diagonal().setConstant(bodies[0].mass);
    M.block<3, 3>(3, 0) = CrossMatrix(bodies[0].moment);
    M.block<3, 3>(3, 3) = bodies[0].inertia;
  }
  M.triangularView<Eigen::StrictlyUpper>() = M.transpose();
  return M;
}

// A joint's damper acts at the step's end, so it counts with the inertia.
void TreeBody::FindAnswers(double step_s) {
  Inertia M = MassMatrix();
  for (std::size_t i = 1; i < links_.size(); ++i) {
    if (speed_of_[i] < 0 || links_[i].damping_nms_per_rad <= 0.0) continue;
    M(speed_of_[i], speed_of_[i]) += step_s * links_[i].damping_nms_per_rad;
  }
  mass_.compute(M);
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

// By the factor's columns: for three right sides Eigen's kernels take twice as long.
void TreeBody::AnswerInPlace(FewImpulses& impulses) const {
  const Inertia& L = mass_.matrixLLT();  // its lower half
  const Eigen::Index count = L.rows();
  for (Eigen::Index column = 0; column < impulses.cols(); ++column) {
    double* x = impulses.col(column).data();
    for (Eigen::Index i = 0; i < count; ++i) {
      x[i] /= L(i, i);
      for (Eigen::Index k = i + 1; k < count; ++k) x[k] -= L(k, i) * x[i];
    }
    for (Eigen::Index i = count - 1; i >= 0; --i) {
      for (Eigen::Index k = i + 1; k < count; ++k) x[i] -= L(k, i) * x[k];
      x[i] /= L(i, i);
    }
  }
  if (ties_.rows() > 0) impulses -= tie_answers_ * held_.solve(ties_ * impulses);
}

TreeBody::PointJacobian TreeBody::JacobianOf(int i, const Vector3d& p_G) const {
  PointJacobian J = PointJacobian::Zero(3, speeds_.size());
  if (rules_.base == TreeBase::kFree) {
    J.leftCols<3>().setIdentity();
    J.middleCols<3>(3) = -CrossMatrix(p_G - com_G_[0]);
  }
  for (int at = i; at != 0; at = links_[Place(at)].parent) {
    if (SpeedOf(at) < 0) continue;
    const Vector3d& axis = axis_G_[Place(at)];
    J.col(SpeedOf(at)) =
        links_[Place(at)].IsHinge() ? Vector3d(axis.cross(p_G - motion_[Place(at)].X_GL.p)) : axis;
  }
  return J;
}

TreeBody::PointJacobian TreeBody::TurningOf(int i) const {
  PointJacobian J = PointJacobian::Zero(3, speeds_.size());
  if (rules_.base == TreeBase::kFree) J.middleCols<3>(3).setIdentity();
  for (int at = i; at != 0; at = links_[Place(at)].parent) {
    if (SpeedOf(at) >= 0 && links_[Place(at)].IsHinge()) J.col(SpeedOf(at)) = axis_G_[Place(at)];
  }
  return J;
}

}  // namespace dockyard
