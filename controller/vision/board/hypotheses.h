// Which detection could be which fiducial, by their rotations alone (Tsai et al., III-A.3).
#pragma once

#include <vector>

#include "controller/geometry/board.h"
#include "controller/vision/board/fiducials.h"

namespace dockyard {

struct MarkMatch {
  int id = -1;         // fiducial of the board
  int detection = -1;  // index into the detections

  bool operator==(const MarkMatch&) const = default;
};

/// The product of the namings of the four rotations: (2!)^4 = 16 with two marks of each. At most
/// max_of_one_class detections of one rotation are named.
std::vector<std::vector<MarkMatch>> NamingHypotheses(
    const std::vector<DetectedFiducial>& detections, const FiducialBoard& board,
    std::size_t max_of_one_class);

}  // namespace dockyard
