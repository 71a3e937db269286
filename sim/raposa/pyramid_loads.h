// What acts on the pyramid but for the robot: the ground on its feet, which stick or slide, and its
// cable.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "models/parts/soil_model.h"
#include "models/raposa/pyramid_model.h"
#include "sim/cable/cable.h"
#include "sim/rigid/ground_contact.h"
#include "sim/rigid/tree_body.h"

namespace dockyard::raposa {

/// The pyramid as a free body, its frame P the link's.
TreeBody MakePyramid(const PyramidModel& pyramid, const Pose3& X_GP);

class PyramidLoads {
 public:
  /// cable_to_G: the fixed far end of its cable, on the ground. soils: of the ground's
  /// numbers 0, 1, ...; the feet sink into those that are there.
  PyramidLoads(const PyramidModel& pyramid, const Pose3& X_GP, const Eigen::Vector3d& cable_to_G,
               const std::vector<std::optional<SoilModel>>& soils);

  /// Of the next step.
  void AddTo(TreeBody& pyramid, const HeightGrid& ground, const Eigen::Vector3d& gravity_G,
             double dt_s);
  /// From the far end to the pyramid at X_GP.
  std::vector<Eigen::Vector3d> CableLine(const Pose3& X_GP) const;
  double cable_pull_n() const { return cable_pull_n_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  Eigen::Vector3d CableEndInG(const Pose3& X_GP) const;
  void PullCable(TreeBody& pyramid, const HeightGrid& ground, const Eigen::Vector3d& gravity_G,
                 double dt_s);

  PyramidModel pyramid_;
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
