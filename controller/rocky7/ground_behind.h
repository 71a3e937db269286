// What is behind the rover, by its back cameras: for a retreat.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/rocky7/ground_stereo.h"

namespace dockyard::rocky7 {

class GroundBehind {
 public:
  explicit GroundBehind(const Nominal& nominal);

  /// Middles of cells, in R's plan, that are higher over the ground than wheels and body pass, up
  /// to 0.75 m behind the rover. The ground is the plane of the attitude.
  std::vector<Eigen::Vector2d> Obstacles(const StereoImages& images,
                                         const ImuSample& attitude) const;

 private:
  const RoverPlan plan_;
  GroundStereo stereo_;  // with the back pair for the front one
};

}  // namespace dockyard::rocky7
