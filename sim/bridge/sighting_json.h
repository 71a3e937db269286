// What a program found in its images: the keys `marks` and `pose` of its belief.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "controller/io/belief.h"
#include "sim/base/json.h"

namespace dockyard {

/// Marks of one frame, at most. Assumed, 64-4096.
inline constexpr std::size_t kMostMarks = 256;

/// Of the answer to one frame; a later belief replaces what an earlier one said.
struct SightingParts {
  std::optional<std::vector<SightingReport::Mark>> marks;
  std::optional<Pose3> X_RB;  // the target in the robot's body
  bool any() const { return marks || X_RB; }
};

/// Takes the keys `marks` and `pose`, where they are there. Throws AnswerError for another shape, a
/// number that is not finite or too large, a camera that the robot has not, too many marks, and a
/// matrix that is no rotation.
void TakeSightingParts(const Json& belief, int camera_count, SightingParts& parts);

/// The sighting that they make: accepted if there is a pose.
SightingReport ReportOf(const SightingParts& parts, int camera_count);

}  // namespace dockyard
