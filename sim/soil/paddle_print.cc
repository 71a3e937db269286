#include "sim/soil/paddle_print.h"

#include <algorithm>
#include <cmath>

#include "sim/soil/moved_soil.h"

namespace dockyard {
namespace {

// Soil is moved from or to points so far apart, in cells, that their sums have no ripple.
constexpr double kApart = 0.5;

/// Adds a prism along the plate, of a triangle's section half_m to both sides of its middle, which
/// is `ahead_m` before the plate.
void AddPrism(HeightGrid& grid, const PaddlePrint& print, double ahead_m, double half_m,
              double volume_m3) {
  const double apart_m = kApart * grid.cell_m;
  const int along = std::max(1, static_cast<int>(std::ceil(2.0 * half_m / apart_m)));
  const int across = std::max(1, static_cast<int>(std::ceil(print.width_m / apart_m)));
  const Eigen::Vector2d ahead(print.across.y(), -print.across.x());
  const auto place = [](int i, int count) { return (i + 0.5) / count - 0.5; };  // -0.5 to 0.5
  const auto height = [&](int i) { return 1.0 - 2.0 * std::abs(place(i, along)); };
  double heights = 0.0;
  for (int i = 0; i < along; ++i) heights += height(i);
  for (int i = 0; i < along; ++i) {
    const double share = height(i) / heights / across;
    for (int k = 0; k < across; ++k) {
      AddSoil(grid,
              print.at + (ahead_m + 2.0 * half_m * place(i, along)) * ahead +
                  print.width_m * place(k, across) * print.across,
              share * volume_m3);
    }
  }
}

}  // namespace

void LeavePrint(HeightGrid& grid, const PaddlePrint& print, double tan_repose) {
  if (print.depth_m <= 0.0) return;
  const double section_m2 = print.thickness_m * print.depth_m;
  const double volume_m3 = section_m2 * print.width_m;
  // Half widths of triangles of that section and of half of it.
  const double groove_m = std::sqrt(section_m2 / tan_repose);
  const double ridge_m = std::sqrt(0.5 * section_m2 / tan_repose);
  AddPrism(grid, print, 0.0, groove_m, -volume_m3);
  for (const double side : {1.0, -1.0}) {
    AddPrism(grid, print, side * (groove_m + ridge_m), ridge_m, 0.5 * volume_m3);
  }
}

}  // namespace dockyard
