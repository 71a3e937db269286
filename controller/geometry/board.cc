#include "controller/geometry/board.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {

int MarksNeeded(const FiducialBoard& board) {
  const int count = static_cast<int>(board.fiducials.size());
  if (board.HasBars()) return std::min(5, count);
  return std::max(5, (count + 1) / 2);
}

bool HasTwoOfEachRotation(const FiducialBoard& board) {
  std::array<int, 4> count{};
  for (const Fiducial& mark : board.fiducials) {
    const long eighths = std::lround(mark.rotation / (kPi / 4.0));
    count[static_cast<std::size_t>(((eighths % 4) + 4) % 4)] += 1;
  }
  return board.HasBars() && count == std::array<int, 4>{2, 2, 2, 2};
}

}  // namespace dockyard
