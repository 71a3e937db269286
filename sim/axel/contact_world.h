// Bullet's world: integrates rover and station and resolves the contacts between them. Without a
// contact it has no constraint rows. It has no ground: soil and feet act as loads.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <memory>

#include "sim/axel/rover_body.h"
#include "sim/axel/station_body.h"
#include "sim/axel/wedge_pairs.h"

namespace dockyard::axel {

/// Sum of the station's contact forces on the arm, in G [N].
struct ArmContact {
  Eigen::Vector3d total_G = Eigen::Vector3d::Zero();
  Eigen::Vector3d face_G = Eigen::Vector3d::Zero();  // the part on the annular face
  int points = 0;
};

class ContactWorld {
 public:
  ContactWorld(const ConeModel& cone, double gravity_m_s2, RoverBody& rover, StationBody& station);
  ~ContactWorld();
  ContactWorld(const ContactWorld&) = delete;
  ContactWorld& operator=(const ContactWorld&) = delete;

  /// One step under the loads given to rover and station.
  void Step(double dt_s);
  const ArmContact& arm_contact() const { return contact_; }

 private:
  class BulletWorld;
  bool MayTouch() const;
  void GiveContactsTheirMaterials();
  void ReadContacts(double dt_s);

  ConeModel cone_;
  RoverBody& rover_;
  StationBody& station_;
  btDefaultCollisionConfiguration configuration_;
  WedgePairsCreator wedge_pairs_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  std::unique_ptr<BulletWorld> world_;
  ArmContact contact_;
};

}  // namespace dockyard::axel
