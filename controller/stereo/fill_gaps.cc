#include "controller/stereo/fill_gaps.h"

#include <cmath>
#include <vector>

namespace dockyard {
namespace {

// Of the step across a gap, what the ground may be off the straight line. Assumed, 0.05-0.3.
constexpr double kOffLine = 0.1;

struct Filled {
  double height_m = 0.0, variance_m2 = 0.0;
  int lines = 0;
};

// A row or a column of the map: `count` cells, `stride` apart.
void FillLine(const ElevationMap& map, int first, int stride, int count, int most_cells,
              std::vector<Filled>& filled) {
  int known = -1;  // the last known cell
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(first + i * stride);
    if (std::isnan(map.height_m[at])) continue;
    if (known >= 0 && i - known - 1 >= 1 && i - known - 1 <= most_cells) {
      const auto from = static_cast<std::size_t>(first + known * stride);
      const double low = map.height_m[from], high = map.height_m[at];
      for (int k = known + 1; k < i; ++k) {
        const double share = static_cast<double>(k - known) / (i - known);
        const double sigma = (1.0 - share) * map.sigma_m[from] + share * map.sigma_m[at];
        const double off = kOffLine * (high - low);
        Filled& cell = filled[static_cast<std::size_t>(first + k * stride)];
        cell.height_m += low + share * (high - low);
        cell.variance_m2 += sigma * sigma + off * off;
        ++cell.lines;
      }
    }
    known = i;
  }
}

}  // namespace

void FillGaps(int most_cells, ElevationMap& map) {
  std::vector<Filled> filled(map.height_m.size());
  for (int iy = 0; iy < map.ny; ++iy) FillLine(map, iy * map.nx, 1, map.nx, most_cells, filled);
  for (int ix = 0; ix < map.nx; ++ix) FillLine(map, ix, map.nx, map.ny, most_cells, filled);
  for (std::size_t i = 0; i < filled.size(); ++i) {
    if (filled[i].lines == 0) continue;
    map.height_m[i] = static_cast<float>(filled[i].height_m / filled[i].lines);
    map.sigma_m[i] = static_cast<float>(std::sqrt(filled[i].variance_m2 / filled[i].lines));
  }
}

}  // namespace dockyard
