#include "sim/rigid/near_parts.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <algorithm>

#include "controller/base/check.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard {

struct NearParts::Part {
  Eigen::Vector3d centre_L{0, 0, 0};
  double radius_m = 0.0;
  Pose3 X_GL, searched_X_GL;  // now, and at the last search
  btConvexHullShape shape;
  btCollisionObject object;

  /// How far a point of it has gone since the last search, at most.
  double Moved() const {
    return (X_GL * centre_L - searched_X_GL * centre_L).norm() +
           radius_m * (X_GL.R - searched_X_GL.R).norm();
  }
};

struct NearParts::BulletSide {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
};

NearParts::NearParts(double within_m)
    : within_m_(within_m), bullet_(std::make_unique<BulletSide>()) {
  DOCKYARD_CHECK(within_m > 0.0);
}

NearParts::~NearParts() {
  for (const auto& part : parts_) bullet_->world.removeCollisionObject(&part->object);
}

int NearParts::Add(const ConvexBody& body_L, const Pose3& X_GL, const PartGroups& groups) {
  auto part = std::make_unique<Part>();
  part->centre_L = body_L.centre;
  part->radius_m = body_L.radius_m;
  part->X_GL = X_GL;
  for (const Eigen::Vector3d& vertex : body_L.vertices) {
    part->shape.addPoint(ToBullet(vertex), false);
  }
  // The boxes hold all that is near.
  part->shape.setMargin(within_m_);
  part->shape.recalcLocalAabb();
  part->object.setCollisionShape(&part->shape);
  part->object.setWorldTransform(ToBullet(X_GL));
  part->object.setUserIndex(static_cast<int>(parts_.size()));
  bullet_->world.addCollisionObject(&part->object, groups.group, groups.meets);
  parts_.push_back(std::move(part));
  searched_ = false;
  return static_cast<int>(parts_.size()) - 1;
}

void NearParts::Place(int part, const Pose3& X_GL) {
  parts_[static_cast<std::size_t>(part)]->X_GL = X_GL;
}

const std::vector<NearPair>& NearParts::Find() {
  // Two parts come nearer by no more than both have moved.
  double most_m = 0.0, next_m = 0.0;
  for (const auto& part : parts_) {
    const double moved_m = part->Moved();
    if (moved_m > most_m) {
      next_m = most_m;
      most_m = moved_m;
    } else {
      next_m = std::max(next_m, moved_m);
    }
  }
  if (!searched_ || most_m + next_m >= within_m_) Search();
  return pairs_;
}

void NearParts::Search() {
  for (const auto& part : parts_) {
    if (searched_ && part->Moved() == 0.0) continue;
    part->searched_X_GL = part->X_GL;
    part->object.setWorldTransform(ToBullet(part->X_GL));
    bullet_->world.updateSingleAabb(&part->object);
  }
  bullet_->world.computeOverlappingPairs();
  pairs_.clear();
  const btBroadphasePairArray& found = bullet_->world.getPairCache()->getOverlappingPairArray();
  for (int i = 0; i < found.size(); ++i) {
    const auto Object = [](const btBroadphaseProxy* proxy) {
      return static_cast<const btCollisionObject*>(proxy->m_clientObject);
    };
    const btCollisionObject *one = Object(found[i].m_pProxy0), *other = Object(found[i].m_pProxy1);
    const auto Shape = [](const btCollisionObject* object) {
      return static_cast<const btConvexHullShape*>(object->getCollisionShape());
    };
    const btTransform &X_one = one->getWorldTransform(), &X_other = other->getWorldTransform();
    btGjkEpaSolver2::sResults result;
    const bool apart = btGjkEpaSolver2::Distance(Shape(one), X_one, Shape(other), X_other,
                                                 X_one.getOrigin() - X_other.getOrigin(), result);
    if (apart && result.distance >= within_m_) continue;
    const int a = one->getUserIndex(), b = other->getUserIndex();
    pairs_.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const NearPair& one, const NearPair& other) {
    return one.a != other.a ? one.a < other.a : one.b < other.b;
  });
  searched_ = true;
  ++searches_;
}

}  // namespace dockyard
