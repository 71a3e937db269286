// The path up a slope that is too steep to drive straight up: by a place aside, so that the rover
// climbs at 45 deg to the slope's line, to there and from there to the target.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/io/sensors.h"

namespace dockyard::rocky7 {

class Detour {
 public:
  /// Where the target lies up a steep slope, from the place of R that is to reach it. Each detour
  /// goes to the other side than the one before. Else nothing happens.
  void Begin(const Eigen::Vector2d& p_PT_R, const ImuSample& attitude);
  /// Where that place should go, from the target, in R; none: straight to the target.
  std::optional<Eigen::Vector2d> FromTarget(double yaw_rad) const;
  /// An image pair: it ends near its place, or where it comes no nearer.
  void Update(const Eigen::Vector2d& p_PT_R, double yaw_rad);

 private:
  std::optional<Eigen::Vector2d> p_TD_;  // in the axes of yaw 0
  double side_ = 1.0;
  double nearest_m_ = 1e9;
  int stalls_ = 0;
};

}  // namespace dockyard::rocky7
