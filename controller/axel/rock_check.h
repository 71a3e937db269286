// Which drives put the rover or its tether over a rock that it was told of.
#pragma once

#include <vector>

#include "controller/axel/plan_geometry.h"
#include "controller/motion/arcs.h"

namespace dockyard::axel {

/// Of a drive over one rock, in metres of way, and the same again for each metre too near. More
/// than any other plan costs, so that a plan over a rock is taken only if there is no other.
inline constexpr double kRockCost_m = 1e3;

/// Whether the body of a rover that stands here is over or near a rock that it does not clear.
bool BodyNearRock(const PlanGeometry& geometry, const Pose2& X_DR, const RockLimits& limits = {});

/// The rocks of a map that the rover cannot pass over, for a plan from one pose. A rock that is
/// nearer than wanted at the start may be as near on the way, but no nearer.
class RockCheck {
 public:
  RockCheck(const PlanGeometry& geometry, const Pose2& X_DR_start, const RockLimits& limits = {});

  bool empty() const { return rocks_.empty(); }
  /// Cost of the rocks that an arc from X_DR crosses [m]; 0 if it is clear of all.
  double Cost(const Pose2& X_DR, const Arc& arc) const;
  double Cost(const Pose2& X_DR, const std::vector<Arc>& arcs) const;

 private:
  struct Kept {
    MappedRock rock;
    double wheel_m = 0.0, body_m = 0.0, arm_m = 0.0;  // distances to keep from its middle; 0: none
    bool tether = false;
  };
  double WheelDistance(const Pose2& X_DR, const Arc& arc, const MappedRock& rock) const;
  double BodyDistance(const Pose2& X_DR, const Arc& arc, const MappedRock& rock) const;
  double ArmDistance(const Pose2& X_DR, const Arc& arc, const MappedRock& rock) const;
  double TetherDepth(const Pose2& X_DR, const MappedRock& rock) const;

  double arm_m_ = 0.0, wheel_radius_m_ = 0.0, half_track_m_ = 0.0, mouth_height_m_ = 0.0;
  RockLimits limits_;
  std::vector<Kept> rocks_;
};

}  // namespace dockyard::axel
