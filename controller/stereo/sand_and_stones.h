// Ground and what lies on it, each by the matcher that serves it: sand smooth and wide, stones
// sharp.
#pragma once

#include "controller/stereo/match.h"

namespace dockyard {

struct SandAndStonesSettings {
  MatchSettings sand{.matcher = Matcher::kSemiGlobal,
                     .block_px = 7,
                     .least_px = -16,
                     .count_px = 64,
                     .smooth_px = 1.0};
  MatchSettings stones{
      .matcher = Matcher::kSemiGlobal, .block_px = 3, .least_px = -16, .count_px = 64};
  // The stones' disparity counts where it differs from the middle of its surroundings by more than
  // this, and the sand's the same way by three quarters of it, which noise alone does not: 1 px are
  // 5 mm of height at 0.3 m and 1 cm at 1 m. Assumed, 0.7-1.5.
  double stands_out_px = 1.0;
  // Half the side of the surroundings, in tiles of 8 px: more than half of them must be ground.
  // Assumed, 3-7.
  int around_tiles = 4;
  int beside_px = 3;  // and so far beside such pixels; assumed, 2-5
};

/// The two disparities of one pair, merged. `ground` as MatchSettings has it.
Disparities MergeStones(const Disparities& sand, const Disparities& stones,
                        const PlaneDisparity& ground, const SandAndStonesSettings& settings);

/// Both searches and their merging. Errors as Match.
Disparities MatchSandAndStones(const Rectifier& rectifier, const StereoImages& images,
                               const PlaneDisparity& ground,
                               const SandAndStonesSettings& settings = {});

/// Leaves pixels out that have one within beside_px whose disparity over the ground's is smaller by
/// more than drop_px: at the edge of what stands in front, a block sees both, and what is behind
/// gets the distance of what is in front. For maps of heights, in which such pixels lie behind a
/// stone at its height.
Disparities WithoutEdges(const Disparities& disparities, const PlaneDisparity& ground,
                         int beside_px = 1, double drop_px = 0.5);

}  // namespace dockyard
