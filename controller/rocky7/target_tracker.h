// A target on the ground, followed from one look to the next.
#pragma once

#include <Eigen/Core>
#include <string>

#include "controller/geometry/pose.h"
#include "controller/stereo/elevation.h"

namespace dockyard::rocky7 {

/// Where a look has the target, in E; or why it has it not.
struct TargetSeen {
  bool found = false;
  bool gone = false;  // it is seen that nothing stands there
  Eigen::Vector2d p_E{0, 0};
  double height_m = 0.0;  // over the level ground below R
  std::string why{};      // in a few words; empty when found without a remark
};

class TargetTracker {
 public:
  virtual ~TargetTracker() = default;
  /// The first look: the user clicked on this place of the ground.
  virtual TargetSeen Begin(const ElevationMap& map, const Eigen::Vector2d& p_E_clicked) = 0;
  /// A later one. X_ET: where odometry has the target, and how the rover has turned since the last
  /// one that found it.
  virtual TargetSeen Follow(const ElevationMap& map, const Pose2& X_ET_predicted) = 0;
  /// After a grasp: whether the target still stands there, among what the scoops have dug up.
  virtual TargetSeen Check(const ElevationMap& map, const Pose2& X_ET) { return Follow(map, X_ET); }
};

}  // namespace dockyard::rocky7
