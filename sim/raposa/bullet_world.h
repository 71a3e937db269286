// One step of robot and pyramid: where the two may meet, with the contacts of pyramid and socket,
// with those that Bullet finds between all else, and with its solver; without them where they are
// apart.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/raposa/mating_solver.h"
#include "sim/raposa/pyramid_body.h"
#include "sim/raposa/robot_body.h"
#include "sim/rigid/bore_contacts.h"

namespace dockyard::raposa {

class BulletWorld {
 public:
  /// Both bodies must outlive this. search_always: for contacts, wherever the two are.
  BulletWorld(RobotBody& robot, PyramidBody& pyramid, const RobotModel& robot_model,
              const PyramidModel& pyramid_model, const Eigen::Vector3d& gravity_G,
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
  // Bullet's world with our contacts after its own.
  struct SearchedWorld : btMultiBodyDynamicsWorld {
    using btMultiBodyDynamicsWorld::btMultiBodyDynamicsWorld;
    void performDiscreteCollisionDetection() override;
    BulletWorld* owner = nullptr;
  };
  // The points of one edge on one surface.
  struct SocketPair {
    int pair = 0;
    btPersistentManifold* manifold = nullptr;
    bool found = false;
  };
  static Ball BallOf(const btCollisionObject& object);
  bool AreApart() const;
  void StepApart(double dt_s);
  void MeetSocket();
  SocketPair& PairOf(int pair);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  MatingSolver solver_;
  SearchedWorld world_;
  RobotBody& robot_body_;
  PyramidBody& pyramid_body_;
  btMultiBody& robot_;
  btRigidBody& pyramid_;
  Pose3 X_RC_;  // of the socket's walls
  double socket_friction_ = 0.0;
  BoreContacts socket_;
  std::vector<BoreContact> contacts_;
  std::vector<SocketPair> pairs_;
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
