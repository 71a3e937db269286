#include "sim/axel/module_contacts.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <cmath>

#include "sim/rigid/bullet_math.h"

namespace dockyard::axel {
namespace {

// Pieces further apart than this, and than twice what the link moved in the last step, do not meet
// in the next: by a tenth of a millimetre more the link would have to speed up by 0.1 m/s in 1 ms,
// ten times g.
constexpr double kGap_m = 0.1e-3;
constexpr double kGapSteps = 2.0;

const btCompoundShape& Compound(const btCollisionObject& body) {
  return static_cast<const btCompoundShape&>(*body.getCollisionShape());
}

const btConvexShape& Piece(const btCollisionObject& body, int piece) {
  return static_cast<const btConvexShape&>(*Compound(body).getChildShape(piece));
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

}  // namespace

ModuleContacts::ModuleContacts(RoverBody& rover, StationBody& station)
    : rover_(rover), station_(station), dispatcher_(&configuration_) {
  const btCollisionObject& module = *station.collision_object();
  for (int i = 0; i < kRoverLinkCount; ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    const btCompoundShape& pieces = Compound(*rover.collider(link));
    for (int a = 0; a < pieces.getNumChildShapes(); ++a) {
      for (int b = 0; b < Compound(module).getNumChildShapes(); ++b) {
        if (link == RoverLink::kArm && !station.MeetsArm(b)) continue;
        pairs_.push_back({link, a, b});
      }
    }
    btVector3 low, high;
    pieces.getAabb(btTransform::getIdentity(), low, high);
    reach_m_[i] = (-low).absolute().length() + high.absolute().length();
    last_X_SL_[i].setIdentity();
  }
}

ModuleContacts::~ModuleContacts() {
  for (Pair& pair : pairs_) Part(pair);
}

void ModuleContacts::Part(Pair& pair) {
  if (pair.algorithm == nullptr) return;
  pair.algorithm->~btCollisionAlgorithm();
  dispatcher_.freeCollisionAlgorithm(pair.algorithm);
  pair.algorithm = nullptr;
}

// Bound of the motion of any point of the link against the station since the last call.
double ModuleContacts::MovedSinceLastStep(RoverLink link, const btTransform& X_SL) {
  btTransform& last = last_X_SL_[static_cast<int>(link)];
  double turned = 0.0;  // square of the Frobenius norm of the change
  for (int row = 0; row < 3; ++row) {
    turned += (X_SL.getBasis()[row] - last.getBasis()[row]).length2();
  }
  const double moved = (X_SL.getOrigin() - last.getOrigin()).length();
  last = X_SL;
  return moved + std::sqrt(turned) * reach_m_[static_cast<int>(link)];
}

// A lower bound of the distance; 0 unless beyond the gap one of the station piece's faces parts
// them. X_SR: rover's piece in the station's shape frame.
double ModuleContacts::Separation(const btConvexShape& rover_piece, const btTransform& X_SR,
                                  int station_piece, double gap_m) const {
  for (const StationFace& face : station_.Faces(station_piece)) {
    const btVector3 towards = X_SR.getBasis().transpose() * -face.normal;
    const btVector3 nearest = X_SR * rover_piece.localGetSupportingVertex(towards);
    const double distance = face.normal.dot(nearest) - face.offset_m;
    if (distance > gap_m) return distance;
  }
  return 0.0;
}

void ModuleContacts::PlaceColliders() {
  for (int i = 0; i < kRoverLinkCount; ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    rover_.collider(link)->setWorldTransform(ToBullet(rover_.X_GP(link)));
  }
}

void ModuleContacts::Test(Pair& pair) {
  const btCollisionObject* rover = rover_.collider(pair.link);
  const btCollisionObject* station = station_.collision_object();
  const btTransform X_GR =
      rover->getWorldTransform() * Compound(*rover).getChildTransform(pair.rover_piece);
  const btTransform X_GS =
      station->getWorldTransform() * Compound(*station).getChildTransform(pair.station_piece);
  const btCollisionObjectWrapper a(nullptr, &Piece(*rover, pair.rover_piece), rover, X_GR, -1,
                                   pair.rover_piece);
  const btCollisionObjectWrapper b(nullptr, &Piece(*station, pair.station_piece), station, X_GS, -1,
                                   pair.station_piece);
  if (pair.algorithm == nullptr) {
    pair.algorithm = dispatcher_.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  }
  btManifoldResult result(&a, &b);
  pair.algorithm->processCollision(&a, &b, info_, &result);
}

void ModuleContacts::Read(const Pair& pair, std::vector<ModuleContact>& contacts) const {
  btManifoldArray manifolds;
  pair.algorithm->getAllContactManifolds(manifolds);
  for (int i = 0; i < manifolds.size(); ++i) {
    const bool rover_is_0 = manifolds[i]->getBody0() == rover_.collider(pair.link);
    for (int j = 0; j < manifolds[i]->getNumContacts(); ++j) {
      const btManifoldPoint& point = manifolds[i]->getContactPoint(j);
      const Eigen::Vector3d normal_G = FromBullet(point.m_normalWorldOnB);
      contacts.push_back(
          {pair.link, static_cast<int>(&pair - pairs_.data()),
           FromBullet(rover_is_0 ? point.getPositionWorldOnA() : point.getPositionWorldOnB()),
           rover_is_0 ? normal_G : Eigen::Vector3d(-normal_G), double{point.getDistance()}});
    }
  }
}

void ModuleContacts::Find(double step_s, std::vector<ModuleContact>& contacts) {
  contacts.clear();
  info_.m_timeStep = step_s;
  PlaceColliders();
  const btTransform X_SG = station_.collision_object()->getWorldTransform().inverse();
  double moved = 0.0, gap = 0.0;
  const btCollisionObject* rover = nullptr;
  btTransform X_SL;
  for (Pair& pair : pairs_) {
    if (rover != rover_.collider(pair.link)) {
      rover = rover_.collider(pair.link);
      X_SL = X_SG * rover->getWorldTransform();
      moved = MovedSinceLastStep(pair.link, X_SL);
      gap = kGap_m + kGapSteps * moved;
    }
    pair.clear_m -= moved;
    if (pair.clear_m > gap) continue;
    const btTransform X_SR = X_SL * Compound(*rover).getChildTransform(pair.rover_piece);
    pair.clear_m = Separation(Piece(*rover, pair.rover_piece), X_SR, pair.station_piece, gap);
    if (pair.clear_m > gap) {
      Part(pair);
      continue;
    }
    Test(pair);
    pair.clear_m = Distance(*pair.algorithm);
    if (pair.clear_m > gap) {
      Part(pair);
    } else {
      Read(pair, contacts);
    }
  }
}

}  // namespace dockyard::axel
