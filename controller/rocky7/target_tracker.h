// A target on the ground, followed from one look to the next.
#pragma once

#include <Eigen/Core>
#include <string>

#include "controller/geometry/pose.h"
#include "controller/rocky7/ground_stereo.h"

namespace dockyard::rocky7 {

/// Where a look has the target, in E; or why it has it not.
struct TargetSighting {
  bool found = false;
  bool gone = false;   // it is seen that nothing stands there
  bool guess = false;  // not found, but p_E is better than the prediction
  Eigen::Vector2d p_E{0, 0};
  double height_m = 0.0;   // over the level ground below R
  double further_m = 0.0;  // all stones, further ahead than odometry had them; 0: not known
  std::string why{};       // in a few words; empty when found without a remark
};

/// Where odometry has the target in E: its place, and how the rover has turned since the last look
/// that found or guessed it.
struct Predicted {
  Pose2 X_ET;
  Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();  // by odometry since then
  double way_m = 0.0;  // that the wheels counted since then: stuck, the rover went less
};

class TargetTracker {
 public:
  virtual ~TargetTracker() = default;
  /// The first look: the user clicked on this place of the ground.
  virtual TargetSighting Begin(const GroundMaps& maps, const Clicked& clicked) = 0;
  /// A later one.
  virtual TargetSighting Follow(const GroundMaps& maps, const Predicted& target) = 0;
  /// After a grasp: whether the target still stands there, among what the scoops have dug up.
  virtual TargetSighting Check(const GroundMaps& maps, const Pose2& X_ET) {
    return Follow(maps, {X_ET});
  }
};

}  // namespace dockyard::rocky7
