// One step of robot and pyramid by Bullet: with its search for contacts and its solver where the
// two may meet, without them where they are apart.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <Eigen/Core>
#include <array>

#include "sim/raposa/mating_solver.h"
#include "sim/raposa/pyramid_body.h"
#include "sim/raposa/robot_body.h"

namespace dockyard::raposa {

class BulletWorld {
 public:
  /// Both must outlive this. search_always: for contacts, wherever the two are.
  BulletWorld(RobotBody& robot, PyramidBody& pyramid, const Eigen::Vector3d& gravity_G,
              bool search_always);

  /// Takes the loads that were added to the bodies, and clears them.
  void Step(double dt_s);
  /// Sum of the forces between robot and pyramid in the last step.
  double contact_n() const { return contact_n_; }

 private:
  struct Ball {
    const btCollisionObject* object = nullptr;
    btVector3 center{0, 0, 0};  // in its frame
    btScalar radius = 0.0;
  };
  static Ball BallOf(const btCollisionObject& object);
  bool AreApart() const;
  void StepApart(double dt_s);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  MatingSolver solver_;
  btMultiBodyDynamicsWorld world_;
  btMultiBody& robot_;
  btRigidBody& pyramid_;
  std::array<Ball, kRobotLinkCount> robot_balls_;
  Ball pyramid_ball_;
  btAlignedObjectArray<btScalar> numbers_;  // scratch of Bullet's
  btAlignedObjectArray<btVector3> vectors_;
  btAlignedObjectArray<btMatrix3x3> matrices_;
  btAlignedObjectArray<btQuaternion> turns_;
  double contact_n_ = 0.0;
  bool search_always_ = false;
};

}  // namespace dockyard::raposa
