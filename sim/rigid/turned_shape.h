// A convex solid of revolution for Bullet: exactly round, where a hull of points has facets.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include <Eigen/Core>
#include <vector>

namespace dockyard {

/// The profile drawn in by a margin, so that the solid and the margin round it together have the
/// intended surface; the margin rounds the edges. Each side of the profile, its flat ends included,
/// moves in by the margin. Both profiles: (z, radius), lowest z first, convex, radii > 0.
/// Throws std::invalid_argument when the profile is not convex or thinner than twice the margin.
std::vector<Eigen::Vector2d> DrawnIn(const std::vector<Eigen::Vector2d>& profile_m,
                                     double margin_m);

/// About its z axis. It computes no inertia.
class TurnedConvexShape : public btConvexInternalShape {
 public:
  TurnedConvexShape(const std::vector<Eigen::Vector2d>& profile_m, double margin_m);

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions,
                                                         btVector3* vertices,
                                                         int count) const override;
  void calculateLocalInertia(btScalar mass, btVector3& inertia) const override;
  void getAabb(const btTransform& X, btVector3& low, btVector3& high) const override;
  const char* getName() const override { return "Turned"; }

 private:
  std::vector<Eigen::Vector2d> core_;
};

}  // namespace dockyard
