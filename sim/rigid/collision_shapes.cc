#include "sim/rigid/collision_shapes.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include "sim/rigid/bullet_math.h"
#include "sim/rigid/turned_shape.h"

namespace dockyard {
namespace {

std::unique_ptr<btCollisionShape> MakeHull(const std::vector<Eigen::Vector3d>& points) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Eigen::Vector3d& p : points) hull->addPoint(ToBullet(p), false);
  hull->recalcLocalAabb();
  return hull;
}

struct MakeShape {
  std::unique_ptr<btCollisionShape> operator()(const BoxShape& box) const {
    return std::make_unique<btBoxShape>(ToBullet(Eigen::Vector3d(0.5 * box.size_m)));
  }
  std::unique_ptr<btCollisionShape> operator()(const CylinderShape& cylinder) const {
    return std::make_unique<btCylinderShapeZ>(
        btVector3(cylinder.radius_m, cylinder.radius_m, 0.5 * cylinder.length_m));
  }
  std::unique_ptr<btCollisionShape> operator()(const SphereShape& sphere) const {
    return std::make_unique<btSphereShape>(sphere.radius_m);
  }
  std::unique_ptr<btCollisionShape> operator()(const HullShape& hull) const {
    return MakeHull(hull.points);
  }
  std::unique_ptr<btCollisionShape> operator()(const TurnedShape& turned) const {
    return std::make_unique<TurnedConvexShape>(turned.profile_m, kCollisionMargin_m);
  }
};

}  // namespace

LinkShape::LinkShape() { compound_.setMargin(kCollisionMargin_m); }

void LinkShape::Add(const Collision& collision, const Pose3& X_PL) {
  pieces_.push_back(std::visit(MakeShape{}, collision.shape));
  if (!std::holds_alternative<SphereShape>(collision.shape) &&
      !std::holds_alternative<TurnedShape>(collision.shape)) {
    pieces_.back()->setMargin(kCollisionMargin_m);  // a sphere is all margin
  }
  compound_.addChildShape(ToBullet(X_PL * collision.X_LG), pieces_.back().get());
}

}  // namespace dockyard
