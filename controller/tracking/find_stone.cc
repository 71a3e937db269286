#include "controller/tracking/stone_middle.h"

#include <algorithm>

#include "controller/geometry/pose.h"
#include "controller/tracking/stones_in_map.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

// Whether enough of the window and of what is about it is known.
bool IsSeen(const std::vector<MapCell>& cells, const Vector2d& p_E, double cell_m,
            const StoneMiddleSettings& with) {
  // At 1 m rows of pixels are two cells apart, and a stone hides what is behind it. Assumed,
  // 0.1-0.4.
  constexpr double kKnown = 0.2;
  constexpr std::size_t kLeastCells = 16;
  const auto within = std::count_if(cells.begin(), cells.end(), [&](const MapCell& cell) {
    return (cell.p_E - p_E).norm() < with.window_m;
  });
  const auto Places = [&](double radius_m) {
    return kPi * radius_m * radius_m / (cell_m * cell_m);
  };
  return cells.size() >= kLeastCells &&
         static_cast<double>(cells.size()) >= kKnown * Places(with.window_m + with.ring_m) &&
         static_cast<double>(within) >= kKnown * Places(with.window_m);
}

}  // namespace

StoneMiddle FindStone(const ElevationMap& map, const Vector2d& p_E,
                      const StoneMiddleSettings& with) {
  StoneMiddle found;
  const double radius_m = with.window_m + with.ring_m;
  const std::vector<MapCell> cells = CellsAbout(map, p_E, radius_m);
  if (!IsSeen(cells, p_E, map.cell_m, with)) return found;
  const GroundFit ground = FitGround(cells, p_E, GroundShape::kLevel);
  const Vector2d slope = ground.terms.segment<2>(1);
  found.ground = {ground.terms[0] - slope.dot(p_E), slope.x(), slope.y()};
  found.sigma_m = ground.sigma_m;
  const auto Away = [&](const StoneTop& stone) { return (stone.p_E - p_E).norm(); };
  std::vector<StoneTop> near;  // with their middles in the window, the nearest first
  bool beyond = false;         // something else reaches into it
  for (const StoneTop& stone : TopsAbout(cells, ground, p_E, radius_m, with)) {
    if (Away(stone) <= with.window_m && !stone.cut) {
      near.push_back(stone);
    } else {
      beyond |= stone.nearest_m <= with.window_m;
    }
  }
  std::sort(near.begin(), near.end(),
            [&](const StoneTop& a, const StoneTop& b) { return Away(a) < Away(b); });
  if (near.empty()) {
    found.verdict = beyond ? StoneVerdict::kBorder : StoneVerdict::kFlat;
    return found;
  }
  const StoneTop& stone = near.front();
  const bool several = near.size() > 1 && Away(near[1]) - Away(stone) < with.apart_m;
  found.verdict = several ? StoneVerdict::kSeveral : StoneVerdict::kFound;
  found.p_E = stone.p_E;
  found.height_m = stone.top_m;
  found.half_length_m = stone.half_length_m;
  found.half_width_m = stone.half_width_m;
  found.heading_rad = stone.heading_rad;
  return found;
}

}  // namespace dockyard
