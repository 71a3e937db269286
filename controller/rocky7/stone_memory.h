// The stones about a target as they lie, and the click that meant one of them: from nearer by it
// may turn out to have meant another one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/pose.h"
#include "controller/tracking/stone_field.h"

namespace dockyard::rocky7 {

/// What the user clicked on: a ray from where the cameras were, in the frame of the stones.
struct ClickRay {
  Eigen::Vector2d from{0, 0}, along{0, 0};              // along: for each metre down
  Eigen::Vector2d range_data{0, 0};                     // of the pixel that was clicked on
  double up_m = 0.0, sigma_rad = 0.0;                   // the cameras over the ground there
  Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();  // as the stones' frame has drifted since

  Eigen::Vector2d At(double height_m) const { return from + (up_m - height_m) * along; }
  Eigen::Matrix2d SpreadAt(double height_m) const;
};

class StoneMemory {
 public:
  /// The first look. True where the click means a stone that is seen; else its place is the target.
  bool Begin(const ClickRay& click, double ground_m, const std::vector<FieldStone>& seen);
  /// A later one: stones are moved by what the prediction was off, and those that were seen again
  /// are known better. The others fade.
  void Learn(const std::vector<FieldStone>& seen, const FieldMatch& match,
             const FieldSettings& with);
  /// The target first.
  const std::vector<FieldStone>& stones() const { return stones_; }
  const FieldStone& target() const { return stones_.front(); }
  /// From the axes and the place X_ET that the target had before into E.
  void Turn(const Pose2& X_ET);
  void Shift(const Eigen::Vector2d& by_m);
  /// Takes the stone that the click means, unless the target is settled. A settled target that
  /// images do not show again was a part of the stone next to it: that is taken.
  void Choose();
  void Settle() { settled_ = true; }
  bool HasSeenTargetWell() const;
  /// Whether a stone so far from the target's place is rather one of the others.
  bool IsNeighbour(const Eigen::Vector2d& from_target_m) const;
  /// The target may have been pushed.
  void Loosen(double by_m);

 private:
  double Likelihood(const FieldStone& stone) const;
  bool IsOnRay(const FieldStone& stone) const;
  void TakeWhole();
  /// Two places so near to each other are of one stone: the place that this image shows counts.
  /// shown: by stone, < 0 where it does not.
  void MergeTwins(std::vector<int> shown);

  std::vector<FieldStone> stones_;
  ClickRay click_;
  bool settled_ = false;
  int missed_ = 0;  // image pairs in a row without the target
};

}  // namespace dockyard::rocky7
