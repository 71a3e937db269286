// Where robot and pyramid may meet within a step: the pyramid in the socket on exact surfaces, all
// else piece by piece as Bullet's search finds it.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "models/raposa/pyramid_model.h"
#include "sim/raposa/robot_links.h"
#include "sim/rigid/bore_contacts.h"
#include "sim/rigid/collision_shapes.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard::raposa {

/// Numbers of the world's bodies.
enum WorldBody : int { kRobot, kPyramid };

class MatingContacts {
 public:
  /// search_always: wherever the two are.
  MatingContacts(const RobotModel& robot, const PyramidModel& pyramid, bool search_always);
  ~MatingContacts();
  MatingContacts(const MatingContacts&) = delete;
  MatingContacts& operator=(const MatingContacts&) = delete;

  /// Adds those of its bodies as they are now to the world's next step.
  void Find(RigidWorld& world);

 private:
  struct Ball {
    Eigen::Vector3d centre{0, 0, 0};  // in the link
    double radius_m = 0.0;            // 0: it has no pieces
  };
  /// A link's pieces.
  struct Part {
    void Take(const std::vector<Collision>& pieces);

    LinkShape shape;
    btCollisionObject object;
    Ball ball;
  };
  bool AreApart(const RigidWorld& world) const;
  void FindInSocket(RigidWorld& world);
  void FindPieces(RigidWorld& world);

  bool search_always_;
  std::array<ContactMaterial, kRobotLinkCount> materials_;  // of the links on the pyramid
  Pose3 X_RC_;                                              // of the socket's walls
  BoreContacts socket_;
  std::vector<BoreContact> in_socket_;
  std::array<Part, kRobotLinkCount> links_;
  Part pyramid_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld search_;
};

}  // namespace dockyard::raposa
