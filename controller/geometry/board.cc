#include "controller/geometry/board.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {

Eigen::Vector2d OnBoard(const SquareTag& tag, const Eigen::Vector2d& p_TQ) {
  // Counter-clockwise for the viewer is towards -y, for y points down.
  const double c = std::cos(tag.rotation), s = std::sin(tag.rotation);
  return tag.p_BT + Eigen::Vector2d(c * p_TQ.x() + s * p_TQ.y(), c * p_TQ.y() - s * p_TQ.x());
}

std::array<Eigen::Vector2d, 4> CornersOf(const SquareTag& tag) {
  const double half = 0.5 * tag.size_m;
  return {OnBoard(tag, {-half, -half}), OnBoard(tag, {half, -half}), OnBoard(tag, {half, half}),
          OnBoard(tag, {-half, half})};
}

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
