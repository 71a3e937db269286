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

ModuleContacts::ModuleContacts(const RoverModel& rover, const StationModel& station)
    : shapes_(rover, station), dispatcher_(&configuration_) {
  for (int i = 0; i < LinkCount(rover); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    for (int a = 0; a < shapes_.link(link).pieces(); ++a) {
      for (int b = 0; b < shapes_.station().pieces(); ++b) {
        if (link == RoverLink::kArm && !shapes_.MeetsArm(b)) continue;
        pairs_.push_back({link, a, b});
      }
    }
    last_X_ML_.push_back(btTransform::getIdentity());
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
double ModuleContacts::MovedSinceLastStep(RoverLink link, const btTransform& X_ML) {
  btTransform& last = last_X_ML_[static_cast<std::size_t>(link)];
  double turned = 0.0;  // square of the Frobenius norm of the change
  for (int row = 0; row < 3; ++row) {
    turned += (X_ML.getBasis()[row] - last.getBasis()[row]).length2();
  }
  const double moved = (X_ML.getOrigin() - last.getOrigin()).length();
  last = X_ML;
  return moved + std::sqrt(turned) * shapes_.link(link).reach_m();
}

// A lower bound of the distance; 0 unless beyond the gap one of the station piece's faces parts
// them. X_MR: the rover's piece.
double ModuleContacts::Separation(const btConvexShape& rover_piece, const btTransform& X_MR,
                                  int station_piece, double gap_m) const {
  for (const StationFace& face : shapes_.Faces(station_piece)) {
    const btVector3 towards = X_MR.getBasis().transpose() * -face.normal;
    const btVector3 nearest = X_MR * rover_piece.localGetSupportingVertex(towards);
    const double distance = face.normal.dot(nearest) - face.offset_m;
    if (distance > gap_m) return distance;
  }
  return 0.0;
}

void ModuleContacts::Test(Pair& pair) {
  const ShapedObject &rover = shapes_.link(pair.link), &station = shapes_.station();
  const btTransform X_GR = rover.X_GB() * rover.X_BP(pair.rover_piece);
  const btTransform X_GS = station.X_GB() * station.X_BP(pair.station_piece);
  const btCollisionObjectWrapper a(nullptr, &rover.piece(pair.rover_piece), rover.object(), X_GR,
                                   -1, pair.rover_piece);
  const btCollisionObjectWrapper b(nullptr, &station.piece(pair.station_piece), station.object(),
                                   X_GS, -1, pair.station_piece);
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
    const bool rover_is_0 = manifolds[i]->getBody0() == shapes_.link(pair.link).object();
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

void ModuleContacts::Find(const RoverBody& rover, const StationBody& station, double step_s,
                          std::vector<ModuleContact>& contacts) {
  contacts.clear();
  info_.m_timeStep = step_s;
  shapes_.MoveTo(rover, station);
  const btTransform X_MG = shapes_.station().X_GB().inverse();
  double moved = 0.0, gap = 0.0;
  const ShapedObject* link = nullptr;
  btTransform X_ML;
  for (Pair& pair : pairs_) {
    if (link != &shapes_.link(pair.link)) {
      link = &shapes_.link(pair.link);
      X_ML = X_MG * link->X_GB();
      moved = MovedSinceLastStep(pair.link, X_ML);
      gap = kGap_m + kGapSteps * moved;
    }
    pair.clear_m -= moved;
    if (pair.clear_m > gap) continue;
    pair.clear_m = Separation(link->piece(pair.rover_piece), X_ML * link->X_BP(pair.rover_piece),
                              pair.station_piece, gap);
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
