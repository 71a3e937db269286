#include "sim/axel/wedge_pairs.h"

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <vector>

namespace dockyard::axel {
namespace {

// Pieces further apart than this, and than twice what the link moved in the last step, do not meet
// in the next: by a tenth of a millimetre more the link would have to speed up by 0.1 m/s in 1 ms,
// ten times g.
constexpr double kGapM = 0.1e-3;
constexpr double kGapSteps = 2.0;

const btCompoundShape* Compound(const btCollisionObjectWrapper* body) {
  return static_cast<const btCompoundShape*>(body->getCollisionShape());
}

class WedgePairs : public btCollisionAlgorithm {
 public:
  WedgePairs(const btCollisionAlgorithmConstructionInfo& info, const StationBody& station,
             int rover_pieces, int station_pieces)
      : btCollisionAlgorithm(info), station_(station) {
    pairs_ = std::make_unique<std::vector<Pair>>(
        static_cast<std::size_t>(rover_pieces * station_pieces));
  }
  ~WedgePairs() override {
    for (Pair& pair : *pairs_) Part(pair);
  }

  void processCollision(const btCollisionObjectWrapper* body0,
                        const btCollisionObjectWrapper* body1, const btDispatcherInfo& info,
                        btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1.0;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    for (Pair& pair : *pairs_) {
      if (pair.algorithm != nullptr) pair.algorithm->getAllContactManifolds(manifolds);
    }
  }

 private:
  struct Pair {
    btCollisionAlgorithm* algorithm = nullptr;
    // The pieces are at least this far apart: the distance at the last test, less the motion of the
    // link since. While it exceeds the gap nothing needs a test.
    double clear_m = 0.0;
  };
  void Part(Pair& pair) {
    if (pair.algorithm == nullptr) return;
    pair.algorithm->~btCollisionAlgorithm();
    m_dispatcher->freeCollisionAlgorithm(pair.algorithm);
    pair.algorithm = nullptr;
  }
  double MovedSinceLastStep(const btCompoundShape& link, const btTransform& X_SL);
  double Separation(const btConvexShape& rover_piece, const btTransform& X_SR, int station_piece,
                    double gap_m) const;

  const StationBody& station_;
  std::unique_ptr<std::vector<Pair>> pairs_;
  btTransform last_X_SL_ = btTransform::getIdentity();
};

// Bound of the motion of any point of the link against the station since the last call.
double WedgePairs::MovedSinceLastStep(const btCompoundShape& link, const btTransform& X_SL) {
  btVector3 low, high;
  link.getAabb(btTransform::getIdentity(), low, high);
  const double reach = (-low).absolute().length() + high.absolute().length();
  double turned = 0.0;  // square of the Frobenius norm of the change
  for (int row = 0; row < 3; ++row) {
    turned += (X_SL.getBasis()[row] - last_X_SL_.getBasis()[row]).length2();
  }
  const double moved = (X_SL.getOrigin() - last_X_SL_.getOrigin()).length();
  last_X_SL_ = X_SL;
  return moved + std::sqrt(turned) * reach;
}

// A lower bound of the distance; 0 unless beyond the gap one of the station piece's faces parts
// them. X_SR: rover's piece in the station's shape frame.
double WedgePairs::Separation(const btConvexShape& rover_piece, const btTransform& X_SR,
                              int station_piece, double gap_m) const {
  for (const StationFace& face : station_.Faces(station_piece)) {
    const btVector3 towards = X_SR.getBasis().transpose() * -face.normal;
    const btVector3 nearest = X_SR * rover_piece.localGetSupportingVertex(towards);
    const double distance = face.normal.dot(nearest) - face.offset_m;
    if (distance > gap_m) return distance;
  }
  return 0.0;
}

// The least distance of the points that Bullet has found; 0 when it has found none.
double Distance(btCollisionAlgorithm& algorithm) {
  btManifoldArray manifolds;
  algorithm.getAllContactManifolds(manifolds);
  double distance = 1e9;
  for (int i = 0; i < manifolds.size(); ++i) {
    for (int j = 0; j < manifolds[i]->getNumContacts(); ++j) {
      distance = std::min(distance, double{manifolds[i]->getContactPoint(j).getDistance()});
    }
  }
  return distance < 1e9 ? distance : 0.0;
}

void WedgePairs::processCollision(const btCollisionObjectWrapper* body0,
                                  const btCollisionObjectWrapper* body1,
                                  const btDispatcherInfo& info, btManifoldResult* result) {
  const bool station_is_1 = body1->getCollisionObject() == station_.collision_object();
  const btCollisionObjectWrapper* rover = station_is_1 ? body0 : body1;
  const btCollisionObjectWrapper* station = station_is_1 ? body1 : body0;
  const btCompoundShape *links = Compound(rover), *wedges = Compound(station);
  const btTransform X_SL = station->getWorldTransform().inverse() * rover->getWorldTransform();
  const double moved = MovedSinceLastStep(*links, X_SL);
  const double gap = kGapM + kGapSteps * moved;
  std::size_t index = 0;
  for (int i = 0; i < links->getNumChildShapes(); ++i) {
    const btConvexShape& piece = static_cast<const btConvexShape&>(*links->getChildShape(i));
    const btTransform X_SR = X_SL * links->getChildTransform(i);
    for (int j = 0; j < wedges->getNumChildShapes(); ++j) {
      Pair& pair = (*pairs_)[index++];
      pair.clear_m -= moved;
      if (pair.clear_m > gap) continue;
      pair.clear_m = Separation(piece, X_SR, j, gap);
      if (pair.clear_m > gap) {
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
      if (pair.algorithm == nullptr) {
        pair.algorithm = m_dispatcher->findAlgorithm(a, b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
      }
      result->setBody0Wrap(a);
      result->setBody1Wrap(b);
      result->setShapeIdentifiersA(-1, station_is_1 ? i : j);
      result->setShapeIdentifiersB(-1, station_is_1 ? j : i);
      pair.algorithm->processCollision(a, b, info, result);
      pair.clear_m = Distance(*pair.algorithm);
      if (pair.clear_m > gap) Part(pair);
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

}  // namespace dockyard::axel
