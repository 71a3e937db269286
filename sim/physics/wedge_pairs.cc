#include "sim/physics/wedge_pairs.h"

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <memory>
#include <new>
#include <vector>

namespace dockyard {
namespace {

// Pieces further apart than this cannot meet within a step: 0.5 m/s at 1 ms, ten times the speed
// of driving and reeling.
constexpr double kGapM = 0.5e-3;

const btCompoundShape* Compound(const btCollisionObjectWrapper* body) {
  return static_cast<const btCompoundShape*>(body->getCollisionShape());
}

class WedgePairs : public btCollisionAlgorithm {
 public:
  WedgePairs(const btCollisionAlgorithmConstructionInfo& info, const StationBody& station,
             int rover_pieces, int station_pieces)
      : btCollisionAlgorithm(info), station_(station) {
    pairs_ = std::make_unique<std::vector<btCollisionAlgorithm*>>(
        static_cast<std::size_t>(rover_pieces * station_pieces), nullptr);
  }
  ~WedgePairs() override {
    for (btCollisionAlgorithm*& pair : *pairs_) Part(pair);
  }

  void processCollision(const btCollisionObjectWrapper* body0,
                        const btCollisionObjectWrapper* body1, const btDispatcherInfo& info,
                        btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1.0;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    for (btCollisionAlgorithm* pair : *pairs_) {
      if (pair != nullptr) pair->getAllContactManifolds(manifolds);
    }
  }

 private:
  void Part(btCollisionAlgorithm*& pair) {
    if (pair == nullptr) return;
    pair->~btCollisionAlgorithm();
    m_dispatcher->freeCollisionAlgorithm(pair);
    pair = nullptr;
  }
  bool Apart(const btConvexShape& rover_piece, const btTransform& X_SR, int station_piece) const;

  const StationBody& station_;
  std::unique_ptr<std::vector<btCollisionAlgorithm*>> pairs_;
};

// X_SR: rover's piece in the station's shape frame.
bool WedgePairs::Apart(const btConvexShape& rover_piece, const btTransform& X_SR,
                       int station_piece) const {
  for (const StationFace& face : station_.Faces(station_piece)) {
    const btVector3 towards = X_SR.getBasis().transpose() * -face.normal;
    const btVector3 nearest = X_SR * rover_piece.localGetSupportingVertex(towards);
    if (face.normal.dot(nearest) - face.offset_m > kGapM) return true;
  }
  return false;
}

void WedgePairs::processCollision(const btCollisionObjectWrapper* body0,
                                  const btCollisionObjectWrapper* body1,
                                  const btDispatcherInfo& info, btManifoldResult* result) {
  const bool station_is_1 = body1->getCollisionObject() == station_.collision_object();
  const btCollisionObjectWrapper* rover = station_is_1 ? body0 : body1;
  const btCollisionObjectWrapper* station = station_is_1 ? body1 : body0;
  const btCompoundShape *links = Compound(rover), *wedges = Compound(station);
  const btTransform X_SL = station->getWorldTransform().inverse() * rover->getWorldTransform();
  std::size_t index = 0;
  for (int i = 0; i < links->getNumChildShapes(); ++i) {
    const btConvexShape& piece = static_cast<const btConvexShape&>(*links->getChildShape(i));
    const btTransform X_SR = X_SL * links->getChildTransform(i);
    for (int j = 0; j < wedges->getNumChildShapes(); ++j) {
      btCollisionAlgorithm*& pair = (*pairs_)[index++];
      if (Apart(piece, X_SR, j)) {
        Part(pair);
        continue;
      }
      const btTransform X_GR = rover->getWorldTransform() * links->getChildTransform(i);
      const btTransform X_GW = station->getWorldTransform() * wedges->getChildTransform(j);
      const btCollisionObjectWrapper rover_piece(rover, &piece, rover->getCollisionObject(), X_GR,
                                                 -1, i);
      const btCollisionObjectWrapper station_piece(station, wedges->getChildShape(j),
                                                   station->getCollisionObject(), X_GW, -1, j);
      const btCollisionObjectWrapper* a = station_is_1 ? &rover_piece : &station_piece;
      const btCollisionObjectWrapper* b = station_is_1 ? &station_piece : &rover_piece;
      if (pair == nullptr) {
        pair = m_dispatcher->findAlgorithm(a, b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
      }
      result->setBody0Wrap(a);
      result->setBody1Wrap(b);
      result->setShapeIdentifiersA(-1, station_is_1 ? i : j);
      result->setShapeIdentifiersB(-1, station_is_1 ? j : i);
      pair->processCollision(a, b, info, result);
    }
  }
  result->setBody0Wrap(body0);
  result->setBody1Wrap(body1);
}

}  // namespace

btCollisionAlgorithm* WedgePairsCreator::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0,
    const btCollisionObjectWrapper* body1) {
  const bool station_is_1 = body1->getCollisionObject() == station_.collision_object();
  const int rover_pieces = Compound(station_is_1 ? body0 : body1)->getNumChildShapes();
  const int station_pieces = Compound(station_is_1 ? body1 : body0)->getNumChildShapes();
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(WedgePairs));
  return new (memory) WedgePairs(info, station_, rover_pieces, station_pieces);
}

}  // namespace dockyard
