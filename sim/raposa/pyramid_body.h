// The pyramid as a free rigid body on feet that stick or slide on the ground, with its cable.
#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "models/parts/soil_model.h"
#include "models/raposa/pyramid_model.h"
#include "sim/cable/cable.h"
#include "sim/rigid/collision_shapes.h"
#include "sim/rigid/ground_contact.h"
#include "sim/rigid/inertia.h"
#include "sim/rigid/motion.h"

namespace dockyard::raposa {

class PyramidBody {
 public:
  /// cable_to_G: the fixed far end of its cable, on the ground. soils: of the ground's
  /// numbers 0, 1, ...; the feet sink into those that are there.
  PyramidBody(const PyramidModel& pyramid, const Pose3& X_GP, const Eigen::Vector3d& cable_to_G,
              const std::vector<std::optional<SoilModel>>& soils);

  /// Motion of the frame P.
  const LinkMotion& motion() const { return motion_; }
  /// The ground's and the cable's forces.
  void AddForces(const HeightGrid& ground, const Eigen::Vector3d& gravity_G, double dt_s);
  void Refresh();
  btRigidBody* body() { return body_.get(); }
  /// From the far end to the pyramid.
  std::vector<Eigen::Vector3d> CableLine() const;
  double cable_pull_n() const { return cable_pull_n_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  void AddForce(const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G);
  Eigen::Vector3d CableEndInG() const;
  void PullCable(const HeightGrid& ground, const Eigen::Vector3d& gravity_G, double dt_s);

  PyramidModel pyramid_;
  PrincipalInertia inertia_;
  LinkShape shape_;
  std::unique_ptr<btRigidBody> body_;
  LinkMotion motion_;
  std::vector<GroundMaterial> soles_;  // by the number of the ground under a foot
  std::vector<GroundPoint> feet_;
  CableModel cable_model_;
  Cable cable_;
  Eigen::Vector3d cable_to_G_;
  double last_piece_m_ = 0.0;  // unstretched, from the last mass to the pyramid
  double slack_left_m_ = 0.0;  // not yet let out
  int calm_steps_ = 0;         // for which the cable has hardly moved
  Eigen::Vector3d p_GE_calm_{0, 0, 0}, pull_G_{0, 0, 0};
  double cable_pull_n_ = 0.0;
};

}  // namespace dockyard::raposa
