// The rover as an articulated body: a free body with two wheels and the arm on hinges about y. Only
// contacts and the loads given to it act on it. Its speeds follow Newton's and Euler's laws in
// Kane's form; Bullet's btMultiBody keeps the state and moves it by the speeds.
//
// A rotor on the body turns N times as fast as its joint, so its inertia N^2 J resists the joint's
// own acceleration alone, not the turning of body and link together: it stands on the diagonal of
// the joint-space inertia (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 9.6). The
// terms left out are smaller by 1 / N, some per mille here.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <Eigen/Cholesky>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "models/axel/axel_model.h"
#include "sim/rigid/collision_shapes.h"
#include "sim/rigid/inertia.h"
#include "sim/rigid/motion.h"

namespace dockyard::axel {

enum class RoverLink { kBody, kLeftWheel, kRightWheel, kArm };
inline constexpr int kRoverLinkCount = 4;

/// The model of one link.
const LinkModel& LinkOf(const RoverModel& rover, RoverLink link);

class RoverBody {
 public:
  /// right_first: order of the wheels among the links.
  RoverBody(const RoverModel& rover, const Pose3& X_GR, double arm_rad, bool right_first);
  RoverBody(const RoverBody&) = delete;
  RoverBody& operator=(const RoverBody&) = delete;

  const LinkMotion& motion(RoverLink link) const { return motion_[Index(link)]; }
  double joint_rad(RoverLink link) const { return multibody_->getJointPos(BulletIndex(link)); }
  double joint_rad_s(RoverLink link) const { return multibody_->getJointVel(BulletIndex(link)); }

  /// Loads of the next step, in G. A torque on a joint acts on the link, its opposite on the body.
  void AddForce(RoverLink link, const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G);
  void AddTorque(RoverLink link, const Eigen::Vector3d& torque_G);
  void AddJointTorque(RoverLink link, double torque_nm);

  /// Speeds after a step under the loads, without contacts; positions stay. Forgets the loads.
  void TakeLoads(const Eigen::Vector3d& gravity_G, double step_s);
  /// A step's positions by the speeds.
  void Move(double step_s);
  /// Takes over positions and speeds after either.
  void Refresh();

  /// Generalized speeds: of R's origin in G, of turning in G, of the joints left, right, arm.
  static constexpr int kSpeeds = 9;
  using Speeds = Eigen::Matrix<double, kSpeeds, 1>;
  /// Inertia of these speeds, rotors included [kg, kg m, kg m^2].
  using Inertia = Eigen::Matrix<double, kSpeeds, kSpeeds>;
  Inertia MassMatrix() const { return MassMatrix(InertiasInG()); }
  /// Its factor, as TakeLoads found it; good until Move.
  const Eigen::LLT<Inertia>& MassFactor() const { return mass_; }
  /// Velocity in G of a link's material point at p_G over the speeds, 3 x 9.
  Eigen::Matrix<double, 3, kSpeeds> PointJacobian(RoverLink link, const Eigen::Vector3d& p_G) const;
  void AddSpeeds(const Speeds& change);

  btMultiBody* multibody() { return multibody_.get(); }
  /// Shapes of the arm, in A.
  const std::vector<Collision>& arm_parts() const { return arm_parts_; }
  btMultiBodyLinkCollider* collider(RoverLink link) { return colliders_[Index(link)].get(); }
  /// Radius about the axle's middle that holds the whole rover [m].
  double reach_m() const { return reach_m_; }
  const Eigen::Vector3d& CentreOfMass(RoverLink link) const { return com_G_[Index(link)]; }
  /// The frame of a link's collision shape.
  Pose3 X_GP(RoverLink link) const {
    return motion_[Index(link)].X_GL * inertia_[Index(link)].X_LP;
  }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  static int Index(RoverLink link) { return static_cast<int>(link); }
  int BulletIndex(RoverLink link) const { return bullet_index_[Index(link)]; }
  using LinkInertias = std::array<Eigen::Matrix3d, kRoverLinkCount>;  // about centres of mass
  LinkInertias InertiasInG() const;
  Inertia MassMatrix(const LinkInertias& inertias) const;
  void AddHinge(const RoverModel& rover, RoverLink link);
  void AddCollider(RoverLink link, const std::vector<Collision>& collisions);

  std::array<int, kRoverLinkCount> bullet_index_{};
  std::array<PrincipalInertia, kRoverLinkCount> inertia_;
  std::array<double, kRoverLinkCount> mass_kg_{};
  std::array<double, kRoverLinkCount> rotor_kg_m2_{};  // of the link's joint
  std::array<Eigen::Vector3d, kRoverLinkCount> p_R_hinge_;
  std::vector<Collision> arm_parts_;
  std::array<LinkShape, kRoverLinkCount> shapes_;
  std::unique_ptr<btMultiBody> multibody_;
  std::array<std::unique_ptr<btMultiBodyLinkCollider>, kRoverLinkCount> colliders_;
  std::array<LinkMotion, kRoverLinkCount> motion_;
  std::array<Eigen::Vector3d, kRoverLinkCount> com_G_;
  double reach_m_ = 0.0;
  Speeds loads_ = Speeds::Zero();  // over the speeds [N, N m]
  Eigen::LLT<Inertia> mass_;
};

}  // namespace dockyard::axel
