#include "controller/vision/tags/tag_light.h"

#include <algorithm>

namespace dockyard {
namespace {

// Nodes closer than this would take blurred edges of the pattern for light. Assumed, 4-10 px.
constexpr double kSpacing_px = 6.0;

}  // namespace

LightGrid::LightGrid(int across, double across_px)
    : across_(across),
      a_side_(std::clamp(1 + static_cast<int>(across_px / kSpacing_px), 2, kMostASide)) {}

LightGrid::Place LightGrid::At(const Eigen::Vector2d& cell) const {
  const Eigen::Vector2d along =
      ((cell / across_).array() + 0.5).cwiseMax(0.0).cwiseMin(1.0) * (a_side_ - 1);
  const int x = std::min(static_cast<int>(along.x()), a_side_ - 2);
  const int y = std::min(static_cast<int>(along.y()), a_side_ - 2);
  const double u = along.x() - x, v = along.y() - y;
  const int first = y * a_side_ + x;
  return {.nodes = {first, first + 1, first + a_side_, first + a_side_ + 1},
          .weights = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

double LightGrid::Place::Of(const Levels& levels) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += weights[static_cast<Eigen::Index>(k)] * levels[nodes[k]];
  }
  return sum;
}

}  // namespace dockyard
