// The rover's contact with the ground other than by wheels: the arm's tip when it drags, the body
// after a tumble, further links such as a trailer's wheels.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/axel/axel_model.h"
#include "sim/axel/rover_body.h"
#include "sim/rigid/ground_contact.h"
#include "sim/rigid/marking_contacts.h"

namespace dockyard::axel {

class RoverGround {
 public:
  /// marked_soils: by the ground's numbers, where the contacts sink in and leave marks; none: the
  /// ground is a spring and stays as it is.
  RoverGround(const RoverModel& rover, const std::vector<SoilModel>& marked_soils);

  /// Adds the ground's forces of this step to the rover's loads.
  void AddForces(HeightGrid& ground, double dt_s, RoverBody& rover);
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
    double plate_m = 0.0;  // diameter of a round plate that bears like it, where the soil sinks
    GroundPoint contact;
  };
  void AddShape(RoverLink link, const GroundMaterial& material, const Collision& collision);
  Eigen::Vector3d Force(HeightGrid& ground, std::size_t rim, const Eigen::Vector3d& p_G,
                        const Eigen::Vector3d& v_G, double dt_s);
  static Eigen::Vector3d LowestPoint(const Rim& rim, const Pose3& X_GL);

  std::vector<Rim> rims_;
  std::optional<MarkingContacts> marks_;  // with the rims' numbers, where they leave marks
  double tip_force_n_ = 0.0;
};

}  // namespace dockyard::axel
