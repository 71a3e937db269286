// The docking station among the world's bodies: one free link on feet that stick or slide on the
// ground.
#pragma once

#include <cstdint>
#include <vector>

#include "models/axel/station_model.h"
#include "sim/rigid/ground_contact.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard::axel {

/// Of each foot on this soil; one that does not sink where the feet are hard.
SinkingPlate SoleOf(const StationModel& station, const SoilModel& soil);

class StationBody {
 public:
  /// Adds it to the world, which must outlive it. sole: of each foot, as SoleOf gives it; by
  /// default the feet are hard.
  StationBody(RigidWorld& world, const StationModel& station, const Pose3& X_GS,
              const SinkingPlate& sole = {});
  /// On the soil of the ground's next number.
  void AddSole(const SinkingPlate& sole) { soles_.push_back(MaterialOf(sole)); }

  /// Its tree of one link, and that link's place in the world.
  TreeBody& tree() { return world_.body(body_); }
  const TreeBody& tree() const { return world_.body(body_); }
  BodyLink place() const { return {body_, 0}; }

  /// Motion of the frame S.
  const LinkMotion& motion() const { return tree().motion(0); }
  Pose3 X_GM() const { return motion().X_GL * X_SM_; }
  void AddForce(const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G) {
    tree().AddForce(0, force_G, p_G);
  }
  void AddTorque(const Eigen::Vector3d& torque_G) { tree().AddTorque(0, torque_G); }
  /// The ground's forces on the feet.
  void AddFeetForces(const HeightGrid& ground, double dt_s);

  const LinkModel& link() const { return tree().link(0).model; }
  Eigen::Vector3d CentreOfMass() const { return motion().X_GL * link().p_LoCom_L; }
  Eigen::Matrix3d InverseInertia() const;  // in G, about the centre of mass
  /// How deep the deepest foot has sunk [m]; 0 for hard feet.
  double sunk_m() const;
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  GroundMaterial MaterialOf(const SinkingPlate& sole) const;

  RigidWorld& world_;
  int body_ = 0;
  StationModel station_;
  Pose3 X_SM_;
  std::vector<GroundMaterial> soles_;  // by the number of the soil under a foot
  std::vector<GroundPoint> feet_;
};

}  // namespace dockyard::axel
