#include "sim/rigid/turned_shape.h"

#include <cmath>
#include <stdexcept>

namespace dockyard {
namespace {

// A side of the profile as the half plane normal . (z, r) <= offset.
struct Side {
  Eigen::Vector2d normal;
  double offset = 0.0;
};

Eigen::Vector2d Corner(const Side& a, const Side& b) {
  const double det = a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x();
  return {(a.offset * b.normal.y() - b.offset * a.normal.y()) / det,
          (b.offset * a.normal.x() - a.offset * b.normal.x()) / det};
}

}  // namespace

std::vector<Eigen::Vector2d> DrawnIn(const std::vector<Eigen::Vector2d>& profile_m,
                                     double margin_m) {
  if (profile_m.size() < 2) throw std::invalid_argument("a turned shape needs two corners");
  std::vector<Side> sides{{{-1.0, 0.0}, -profile_m.front().x() - margin_m}};
  for (std::size_t i = 0; i + 1 < profile_m.size(); ++i) {
    const Eigen::Vector2d along = (profile_m[i + 1] - profile_m[i]).normalized();
    const Eigen::Vector2d out(-along.y(), along.x());
    if ((out - sides.back().normal).norm() < 1e-9) continue;  // goes straight on
    sides.push_back({out, out.dot(profile_m[i]) - margin_m});
  }
  sides.push_back({{1.0, 0.0}, profile_m.back().x() - margin_m});
  std::vector<Eigen::Vector2d> core;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Eigen::Vector2d &a = sides[i].normal, &b = sides[i + 1].normal;
    if (!(a.y() * b.x() - a.x() * b.y() > 1e-9)) {
      throw std::invalid_argument("a turned shape's profile must be convex, lowest z first");
    }
    core.push_back(Corner(sides[i], sides[i + 1]));
    const bool shrunk_away =
        core.back().y() <= 0.0 || (core.size() > 1 && core.back().x() < core[core.size() - 2].x());
    if (shrunk_away) throw std::invalid_argument("a turned shape is thinner than its margins");
  }
  return core;
}

TurnedConvexShape::TurnedConvexShape(const std::vector<Eigen::Vector2d>& profile_m, double margin_m)
    : core_(DrawnIn(profile_m, margin_m)) {
  m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
  setMargin(margin_m);
}

btVector3 TurnedConvexShape::localGetSupportingVertexWithoutMargin(
    const btVector3& direction) const {
  const double across = std::hypot(direction.x(), direction.y());
  const Eigen::Vector2d* best = &core_.front();
  double most = -BT_LARGE_FLOAT;
  for (const Eigen::Vector2d& corner : core_) {
    const double reach = corner.x() * direction.z() + corner.y() * across;
    if (reach > most) {
      most = reach;
      best = &corner;
    }
  }
  if (across == 0.0) return {best->y(), 0.0, best->x()};
  const double scale = best->y() / across;
  return {scale * direction.x(), scale * direction.y(), best->x()};
}

void TurnedConvexShape::batchedUnitVectorGetSupportingVertexWithoutMargin(
    const btVector3* directions, btVector3* vertices, int count) const {
  for (int i = 0; i < count; ++i) {
    vertices[i] = localGetSupportingVertexWithoutMargin(directions[i]);
  }
}

void TurnedConvexShape::calculateLocalInertia(btScalar, btVector3& inertia) const {
  inertia.setZero();  // links bring their own
}

void TurnedConvexShape::getAabb(const btTransform& X, btVector3& low, btVector3& high) const {
  for (int axis = 0; axis < 3; ++axis) {
    const btVector3 towards = X.getBasis()[axis];  // the world's axis in the shape's
    const double reach_up = towards.dot(localGetSupportingVertexWithoutMargin(towards));
    const double reach_down = towards.dot(localGetSupportingVertexWithoutMargin(-towards));
    high[axis] = X.getOrigin()[axis] + reach_up + getMargin();
    low[axis] = X.getOrigin()[axis] + reach_down - getMargin();
  }
}

}  // namespace dockyard
