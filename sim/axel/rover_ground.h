// The rover's contact with the ground other than by wheels: the arm's tip when it drags, the body
// after a tumble, further links such as a trailer's wheels.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "models/axel/axel_model.h"
#include "sim/axel/rover_body.h"
#include "sim/rigid/ground_contact.h"

namespace dockyard::axel {

class RoverGround {
 public:
  explicit RoverGround(const RoverModel& rover);

  /// Adds the ground's forces of this step to the rover's loads.
  void AddForces(const HeightGrid& ground, double dt_s, RoverBody& rover);
  /// Ground's force on the arm's tip in the last step [N].
  double tip_force_n() const { return tip_force_n_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  // A circle whose lowest point can touch; radius 0: a corner; no axis: a sphere.
  struct Rim {
    RoverLink link = RoverLink::kBody;
    Eigen::Vector3d p_L = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis_L = Eigen::Vector3d::Zero();
    double radius_m = 0.0;
    GroundMaterial material{};
    GroundPoint contact;
  };
  void AddShape(RoverLink link, const GroundMaterial& material, const Collision& collision);
  static Eigen::Vector3d LowestPoint(const Rim& rim, const Pose3& X_GL);

  std::vector<Rim> rims_;
  double tip_force_n_ = 0.0;
};

}  // namespace dockyard::axel
