// Rocks that the rover has felt: a wheel that comes down from one tilts the axle back.
#pragma once

#include <array>
#include <optional>

#include "controller/axel/ground_slope.h"
#include "controller/axel/nominal/rock_map.h"
#include "controller/axel/options.h"
#include "controller/geometry/pose.h"

namespace dockyard::axel {

class FeltRocks {
 public:
  FeltRocks(double track_m, const FeltRockOptions& options, const RockLimits& limits)
      : half_track_m_(0.5 * track_m), options_(options), limits_(limits) {}

  /// attitude: against the ground. X_OR: by odometry alone, from anywhere. X_DR: the same place in
  /// the dock's frame. Returns a rock that the body would not pass over when a wheel has just come
  /// off it, as a disc in D.
  std::optional<MappedRock> Take(const Attitude& attitude, const Pose2& X_OR, const Pose2& X_DR);
  /// Forgets what the wheels stand on.
  void Reset();

 private:
  // What lifts one wheel: the highest so far, where that was, and the wheel's way since.
  struct Lift {
    double height_m = 0.0;
    Pose2 X_OR;
    double way_m = 0.0;
  };
  double half_track_m_;
  FeltRockOptions options_;
  RockLimits limits_;
  std::array<std::optional<Lift>, 2> lifts_;  // left, right
  std::optional<Pose2> before_;               // X_OR
};

}  // namespace dockyard::axel
