// The docking station: a rigid body on feet that stick or slide on the ground.
#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "models/axel/station_model.h"
#include "sim/rigid/collision_shapes.h"
#include "sim/rigid/ground_contact.h"
#include "sim/rigid/inertia.h"
#include "sim/rigid/motion.h"

namespace dockyard::axel {

/// A plane that bounds a piece of the station, in the frame of its collision shape: the piece lies
/// where normal . p <= offset_m.
struct StationFace {
  btVector3 normal{0, 0, 0};
  double offset_m = 0.0;
};

/// Of each foot on this soil; one that does not sink where the feet are hard.
SinkingPlate SoleOf(const StationModel& station, const SoilModel& soil);

class StationBody {
 public:
  /// sole: of each foot, as SoleOf gives it; by default the feet are hard.
  StationBody(const StationModel& station, const Pose3& X_GS, const SinkingPlate& sole = {});
  /// On the soil of the ground's next number.
  void AddSole(const SinkingPlate& sole) { soles_.push_back(MaterialOf(sole)); }

  /// Motion of the frame S.
  const LinkMotion& motion() const { return motion_; }
  Pose3 X_GM() const { return motion_.X_GL * X_SM_; }
  void AddForce(const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G);
  void AddTorque(const Eigen::Vector3d& torque_G);
  /// The ground's forces on the feet.
  void AddFeetForces(const HeightGrid& ground, double dt_s);
  /// Speeds after a step under the loads, without contacts; positions stay. Forgets the loads.
  void TakeLoads(const Eigen::Vector3d& gravity_G, double step_s);
  void AddImpulse(const Eigen::Vector3d& impulse_G, const Eigen::Vector3d& p_G);
  /// A step's position by the speeds.
  void Move(double step_s);
  void Refresh();

  Eigen::Vector3d CentreOfMass() const { return motion_.X_GL * inertia_.X_LP.p; }
  double inverse_mass_per_kg() const { return body_->getInvMass(); }
  Eigen::Matrix3d InverseInertia() const;  // in G, about the centre of mass
  btRigidBody* body() { return body_.get(); }
  const btCollisionObject* collision_object() const { return body_.get(); }
  const std::vector<StationFace>& Faces(int piece) const {
    return faces_[static_cast<std::size_t>(piece)];
  }
  /// Whether the arm meets a piece elsewhere than in the mating: all but what stands for the cone
  /// and what fills its hole.
  bool MeetsArm(int piece) const { return meets_arm_[static_cast<std::size_t>(piece)]; }
  /// Radius about the mouth that holds the whole station [m].
  double reach_m() const { return reach_m_; }
  /// How deep the deepest foot has sunk [m]; 0 for hard feet.
  double sunk_m() const;
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  void AddShapes();
  void AddFaces();

  StationModel station_;
  Pose3 X_SM_;
  PrincipalInertia inertia_;  // in S, the module tipped
  LinkShape shape_;
  std::vector<bool> meets_arm_;                  // by piece
  std::vector<std::vector<StationFace>> faces_;  // by piece
  std::unique_ptr<btRigidBody> body_;
  LinkMotion motion_;
  GroundMaterial MaterialOf(const SinkingPlate& sole) const;

  std::vector<GroundMaterial> soles_;  // by the number of the soil under a foot
  std::vector<GroundPoint> feet_;
  double reach_m_ = 0.0;
};

}  // namespace dockyard::axel
