// What a tree's speeds answer to impulses: composite inertia, ties, and velocities of points.
#include <array>

#include "sim/rigid/tree_body.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A link and all beyond it, about its centre: mass, first moment, inertia.
struct Composite {
  double mass;
  Vector3d moment;
  Symmetric inertia;
};

// Adds the same bodies about a point that lies -r from the composite's.
void AddShifted(const Composite& at, const Vector3d& r, Composite& onto) {
  const double m = at.mass;
  const Vector3d &c = at.moment, half = c + 0.5 * m * r;
  const double xx = 2.0 * half.x() * r.x(), yy = 2.0 * half.y() * r.y(),
               zz = 2.0 * half.z() * r.z();
  onto.mass += m;
  onto.moment += c + m * r;
  onto.inertia.xx += at.inertia.xx + (yy + zz);
  onto.inertia.yy += at.inertia.yy + (zz + xx);
  onto.inertia.zz += at.inertia.zz + (xx + yy);
  onto.inertia.xy += at.inertia.xy - (half.x() * r.y() + half.y() * r.x());
  onto.inertia.xz += at.inertia.xz - (half.x() * r.z() + half.z() * r.x());
  onto.inertia.yz += at.inertia.yz - (half.y() * r.z() + half.z() * r.y());
}

}  // namespace

void TreeBody::FillInertia(double* rows, Eigen::Index row_length) const {
  const auto count = static_cast<int>(links_.size());
  const bool free = rules_.base == TreeBase::kFree;
  std::array<Composite, kMostLinks> bodies;
  for (int i = 0; i < count; ++i) {
    bodies[Place(i)] = {0.0, Vector3d::Zero(), {}};
    AddShifted({links_[Place(i)].model.mass_kg, Vector3d::Zero(), inertia_G_[Place(i)]},
               com_G_[Place(i)] - Centre(i), bodies[Place(i)]);
  }
  for (int i = count - 1; i > 0; --i) {
    const TreeLink& link = links_[Place(i)];
    const Composite& own = bodies[Place(i)];
    if (SpeedOf(i) >= 0) {
      const Vector3d& axis = axis_G_[Place(i)];
      double* const row = rows + SpeedOf(i) * row_length;
      // Load that a unit rate of this joint alone takes, carried inwards.
      Vector3d force =
          link.IsHinge() ? Vector3d(axis.cross(own.moment)) : Vector3d(own.mass * axis);
      Vector3d torque =
          link.IsHinge() ? Product(own.inertia, axis) : Vector3d(own.moment.cross(axis));
      row[SpeedOf(i)] = link.Along(axis, force, torque) + link.rotor_kg_m2;
      for (int at = i; at != 0;) {
        const int parent = links_[Place(at)].parent;
        torque += (Centre(at) - Centre(parent)).cross(force);
        at = parent;
        if (SpeedOf(at) < 0) continue;
        row[SpeedOf(at)] = links_[Place(at)].Along(axis_G_[Place(at)], force, torque);
      }
      if (free) {
        for (int k = 0; k < 3; ++k) row[k] = force[k], row[3 + k] = torque[k];
      }
    }
    AddShifted(own, Centre(i) - Centre(link.parent), bodies[Place(link.parent)]);
  }
  if (!free) return;
  const Composite& all = bodies[0];
  const Matrix3d cross = CrossMatrix(all.moment), inertia = MatrixOf(all.inertia);
  for (int i = 0; i < 3; ++i) {
    double *const going = rows + i * row_length, *const turning = rows + (3 + i) * row_length;
    for (int j = 0; j < i; ++j) going[j] = 0.0;
    going[i] = all.mass;
    for (int j = 0; j < 3; ++j) turning[j] = cross(i, j);
    for (int j = 0; j <= i; ++j) turning[3 + j] = inertia(i, j);
  }
}

TreeBody::Inertia TreeBody::MassMatrix() const {
  Inertia M = Inertia::Zero(speeds_.size(), speeds_.size());
  FillInertia(M.data(), M.cols());  // its columns are rows there
  M.triangularView<Eigen::StrictlyLower>() = M.transpose();
  return M;
}

// A joint's spring and damper act at the step's end, so they count with the inertia.
void TreeBody::FindAnswers(double step_s) {
  if (flies_alone_) {
    inverse_G_ = TurnedTensor(X_GB_.R, MatrixOf(inverse_L_));
    return;
  }
  FillInertia(factor_.row(0), speeds_.size());
  for (std::size_t i = 1; i < links_.size(); ++i) {
    const double resistance = links_[i].Resistance(step_s);
    if (speed_of_[i] < 0 || resistance <= 0.0) continue;
    const int at = static_cast<int>(speed_of_[i]);
    factor_.row(at)[at] += step_s * resistance;
  }
  factor_.Compute();
  if (ties_.rows() == 0) return;
  tie_answers_ = ties_.transpose();
  for (Eigen::Index i = 0; i < tie_answers_.cols(); ++i) factor_.Solve(tie_answers_.col(i).data());
  held_.compute(ties_ * tie_answers_);
}

TreeBody::Speeds TreeBody::Answer(Speeds impulse) const {
  if (flies_alone_) {
    impulse.head<3>() /= mass_kg_;
    impulse.segment<3>(3) = Product(inverse_G_, Vector3d(impulse.segment<3>(3)));
    return impulse;
  }
  factor_.Solve(impulse.data());
  if (ties_.rows() > 0) impulse -= tie_answers_ * held_.solve(ties_ * impulse);
  return impulse;
}

void TreeBody::AnswerInPlace(LinkImpulses& impulses) const {
  if (flies_alone_) {
    impulses.topRows<3>() /= mass_kg_;
    for (int i = 0; i < 6; ++i) {
      impulses.block<3, 1>(3, i) = Product(inverse_G_, Vector3d(impulses.block<3, 1>(3, i)));
    }
    return;
  }
  factor_.SolveSix(impulses.data());
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

TreeBody::LinkImpulses TreeBody::MotionRowsOf(int i) const {
  LinkImpulses rows = LinkImpulses::Zero(speeds_.size(), 6);
  const Vector3d& p_G = motion_[Place(i)].X_GL.p;
  if (rules_.base == TreeBase::kFree) {
    rows.block<3, 3>(0, 3).setIdentity();
    rows.block<3, 3>(3, 0).setIdentity();
    rows.block<3, 3>(3, 3) = CrossMatrix(p_G - com_G_[0]);
  }
  for (int at = i; at != 0; at = links_[Place(at)].parent) {
    if (SpeedOf(at) < 0) continue;
    const Vector3d& axis = axis_G_[Place(at)];
    const bool turns = links_[Place(at)].IsHinge();
    if (turns) rows.block<1, 3>(SpeedOf(at), 0) = axis.transpose();
    const Vector3d along = turns ? axis.cross(p_G - motion_[Place(at)].X_GL.p) : axis;
    rows.block<1, 3>(SpeedOf(at), 3) = along.transpose();
  }
  return rows;
}

}  // namespace dockyard
