#include "sim/rigid/link_rows.h"

#include <algorithm>

#include "sim/rigid/four_doubles.h"

namespace dockyard {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// at + x a + y b + z c, in one order everywhere.
void AddSum(const FourDoubles& x, const FourDoubles& y, const FourDoubles& z, const double* weights,
            FourDoubles& at) {
  at += x * weights[0] + y * weights[1] + z * weights[2];
}

// The same with a factor of the vectors: a row of an axis each.
void AddScaled(const double* from, const FourDoubles* axes, FourDoubles& at) {
  at += from[0] * axes[0] + from[1] * axes[1] + from[2] * axes[2];
}

// Of three numbers of each speed that moves the link, from the one at `first` on.
DOCKYARD_FOUR_AT_ONCE void AddJacobian(const LinkRows& link, int first, const Matrix3d& weights,
                                       ConstraintEnd& end) {
  FourDoubles axes[3];
  for (int k = 0; k < 3; ++k)
    axes[k] = FourDoubles{weights(k, 0), weights(k, 1), weights(k, 2), 0.0};
  for (const int i : link.moved) {
    double* const to = end.jacobian.data() + 4 * i;
    FourDoubles at;
    Load(to, at);
    AddScaled(link.rows.data() + 6 * i + first, axes, at);
    Store(at, to);
  }
}

// Of three of the link's answers.
DOCKYARD_FOUR_AT_ONCE void AddAnswer(const LinkRows& link, int first, const Matrix3d& weights,
                                     ConstraintEnd& end) {
  const Index places = end.places;
  const double* const from = link.answers.data() + first * places;
  for (Index i = 0; i < places; i += 4) {
    FourDoubles x, y, z;
    Load(from + i, x);
    Load(from + places + i, y);
    Load(from + 2 * places + i, z);
    for (int row = 0; row < 3; ++row) {
      double* const to = end.answer.data() + row * places + i;
      FourDoubles at;
      Load(to, at);
      AddSum(x, y, z, weights.data() + 3 * row, at);
      Store(at, to);
    }
  }
}

void AddMoved(const LinkRows& link, ConstraintEnd& end) {
  if (end.moved == link.moved) return;
  for (const int i : link.moved) {
    const auto at = std::lower_bound(end.moved.begin(), end.moved.end(), i);
    if (at != end.moved.end() && *at == i) continue;
    end.moved.insert(at, i);
    std::fill_n(end.jacobian.data() + 4 * i, 4, 0.0);
  }
}

}  // namespace

void LinkRows::Fill(const TreeBody& tree, int link) {
  p_G = tree.motion(link).X_GL.p;
  rows = tree.MotionRowsOf(link);
  TreeBody::LinkImpulses solved = rows;
  tree.AnswerInPlace(solved);
  answers.setZero(PlacesFor(rows.rows()), 6);
  answers.topRows(rows.rows()) = solved;
  moved.clear();
  for (Index i = 0; i < rows.rows(); ++i) {
    if (!rows.row(i).isZero(0.0)) moved.push_back(static_cast<int>(i));
  }
}

void ConstraintEnd::Clear() {
  first = places = 0;
  moved.clear();
}

void ConstraintEnd::Start(Index first_speed, Index speeds) {
  if (places > 0) return;
  first = first_speed;
  places = PlacesFor(speeds);
  std::fill_n(answer.data(), 3 * places, 0.0);
}

void ConstraintEnd::AddTurning(const LinkRows& link, const Matrix3d& axes) {
  AddMoved(link, *this);
  AddJacobian(link, 0, axes, *this);
  AddAnswer(link, 0, axes, *this);
}

void ConstraintEnd::AddPoint(const LinkRows& link, const Vector3d& p_G, const Matrix3d& axes) {
  AddTurning(link, CrossMatrix(p_G - link.p_G) * axes);
  AddJacobian(link, 3, axes, *this);
  AddAnswer(link, 3, axes, *this);
}

}  // namespace dockyard
