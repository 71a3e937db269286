// Why a tracker lost its target, by the truth: the causes that Nesnas, Maimone and Das (ICRA 2000)
// list.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace dockyard::rocky7 {

/// The number is that of the paper's cause (A1 to A5 here), and of the column `loss`.
enum class Loss {
  kNone = 0,
  kFieldOfView = 1,     // the target leaves the field of view
  kNoRange = 2,         // no range data
  kSeveralTargets = 3,  // several targets in the window
  kOdometry = 4,        // odometry puts the target outside the window
  kColour = 5,          // the target has the background's colour
};

/// A stone in plan.
struct PlanDisc {
  Eigen::Vector2d p_E{0, 0};
  double radius_m = 0.0;
};

/// The truth at an image pair that lost the target. Frame E: the rover's reference point on the
/// ground, level, x ahead.
struct LossTruth {
  bool in_view = true;  // the left image shows the target's middle, and no part of the rover before
  Eigen::Vector2d p_ET{0, 0};                    // the target's middle, in plan
  double target_radius_m = 0.0;                  // of a stone
  double window_m = 0.0;                         // half the side of the search window
  std::optional<Eigen::Vector2d> predicted_E{};  // where the controller expected it; or unknown
  std::optional<Eigen::Vector2d> detected_E{};   // where it was detected wrongly; or nowhere
  std::vector<PlanDisc> others_E{};              // other stones
  bool on_boulder = false;                       // it was detected elsewhere on the boulder
  double albedo_share = 0.65;                    // of the target over that of the ground
};

/// The first cause that holds, in the order field of view, odometry, several targets, colour, range
/// data (docs/reference/outcomes.md). Never kNone.
Loss CauseOf(const LossTruth& truth);

/// Remembers the cause from the first image pair without the target to the next that has it.
class LossRecord {
 public:
  /// The target was detected at its place.
  void Found() { loss_ = Loss::kNone, any_ = true; }
  void Lost(Loss cause);
  /// None without an image pair.
  std::optional<Loss> loss() const { return any_ ? std::optional(loss_) : std::nullopt; }
  /// Whether the next image pair without the target is the first one.
  bool has_target() const { return loss_ == Loss::kNone; }

 private:
  Loss loss_ = Loss::kNone;
  bool any_ = false;
};

}  // namespace dockyard::rocky7
