// The docking station: a rigid body on feet that stick or slide on the ground.
#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "models/axel/station_model.h"
#include "sim/physics/collision_shapes.h"
#include "sim/physics/ground_contact.h"
#include "sim/physics/inertia.h"
#include "sim/physics/motion.h"

namespace dockyard::axel {

/// A plane that bounds a piece of the station, in the frame of its collision shape: the piece lies
/// where normal . p <= offset_m.
struct StationFace {
  btVector3 normal{0, 0, 0};
  double offset_m = 0.0;
};

class StationBody {
 public:
  StationBody(const StationModel& station, const Pose3& X_GS, bool mirrored_order);

  /// Motion of the frame S.
  const LinkMotion& motion() const { return motion_; }
  Pose3 X_GM() const { return motion_.X_GL * X_SM_; }
  void AddForce(const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G);
  /// The ground's forces on the feet.
  void AddFeetForces(const HeightGrid& ground, double dt_s);
  void Refresh();

  btRigidBody* body() { return body_.get(); }
  const btCollisionObject* collision_object() const { return body_.get(); }
  const std::vector<StationFace>& Faces(int piece) const {
    return faces_[static_cast<std::size_t>(piece)];
  }
  /// Whether a piece of the body's shape is a wedge of the cone.
  bool IsWedge(int piece) const { return piece < wedge_count_; }
  /// Whether a piece of the module fills the socket's hole: it has no contact with the arm.
  bool FillsSocket(int piece) const { return fills_socket_[static_cast<std::size_t>(piece)]; }
  /// Radius about the mouth that holds the whole station [m].
  double reach_m() const { return reach_m_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  void AddShapes(bool mirrored_order);
  void AddFaces();

  StationModel station_;
  Pose3 X_SM_;
  PrincipalInertia inertia_;  // in S, the module tipped
  LinkShape shape_;
  int wedge_count_ = 0;
  std::vector<bool> fills_socket_;
  std::vector<std::vector<StationFace>> faces_;  // by piece
  std::unique_ptr<btRigidBody> body_;
  LinkMotion motion_;
  GroundMaterial sole_;
  std::vector<GroundPoint> feet_;
  double reach_m_ = 0.0;
};

}  // namespace dockyard::axel
