#include "sim/page/replay_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/log/ground_over_time.h"

namespace dockyard {
namespace {

constexpr double kMargin_m = 1.0;
constexpr double kHeightQuantum_m = 5e-4;        // ruts are 5-20 mm deep
constexpr std::uint32_t kMostVertices = 50'000;  // more are slow to draw without a graphics card

/// A part of the soil's grid with every `stride`-th sample of it.
struct Window {
  std::uint32_t x0 = 0, y0 = 0, columns = 0, rows = 0, stride = 1;

  std::uint32_t vertices() const { return columns * rows; }
  /// The vertex of a cell of a grid with nx columns; none: it is not shown.
  std::optional<std::uint32_t> VertexOf(std::uint32_t cell, std::uint32_t nx) const {
    const std::uint32_t x = cell % nx, y = cell / nx;
    if (x < x0 || y < y0 || (x - x0) % stride != 0 || (y - y0) % stride != 0) return std::nullopt;
    const std::uint32_t column = (x - x0) / stride, row = (y - y0) / stride;
    if (column >= columns || row >= rows) return std::nullopt;
    return row * columns + column;
  }
};

/// The samples from `low` to `high`, limited to the grid.
std::pair<std::uint32_t, std::uint32_t> Range(double low_m, double high_m, double first_m,
                                              double cell_m, std::uint32_t count) {
  const auto limited = [&](double at) {
    return static_cast<std::uint32_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
  };
  return {limited(std::floor((low_m - first_m) / cell_m)),
          limited(std::ceil((high_m - first_m) / cell_m))};
}

Window WindowOf(const LoggedGround& grid, const std::vector<std::vector<Pose3>>& X_GO) {
  Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const auto& track : X_GO) {
    for (const Pose3& X : track) {
      low = low.min(X.p.head<2>().array());
      high = high.max(X.p.head<2>().array());
    }
  }
  const auto [x0, x1] =
      Range(low.x() - kMargin_m, high.x() + kMargin_m, grid.x0_m, grid.cell_m, grid.nx);
  const auto [y0, y1] =
      Range(low.y() - kMargin_m, high.y() + kMargin_m, grid.y0_m, grid.cell_m, grid.ny);
  Window window{x0, y0, 0, 0, 0};
  do {
    ++window.stride;
    window.columns = (x1 - x0) / window.stride + 1;
    window.rows = (y1 - y0) / window.stride + 1;
  } while (window.vertices() > kMostVertices);
  return window;
}

double Rounded(double height_m) {
  return kHeightQuantum_m * std::round(height_m / kHeightQuantum_m);
}

/// Heights as they are now [m].
std::vector<double> HeightsIn(const Window& window, const std::vector<std::int16_t>& all,
                              const LoggedGround& grid) {
  std::vector<double> heights;
  heights.reserve(window.vertices());
  for (std::uint32_t row = 0; row < window.rows; ++row) {
    for (std::uint32_t column = 0; column < window.columns; ++column) {
      const std::size_t at = std::size_t{window.y0 + row * window.stride} * grid.nx + window.x0 +
                             column * window.stride;
      heights.push_back(Rounded(all[at] * grid.step_m));
    }
  }
  return heights;
}

}  // namespace

Json ReplayGround(const LoggedRun& run, const std::vector<std::vector<Pose3>>& X_GO,
                  Payload& payload) {
  GroundOverTime ground(run);
  if (ground.grid() == nullptr || X_GO.empty()) return nullptr;
  const LoggedGround& grid = *ground.grid();
  const Window window = WindowOf(grid, X_GO);
  std::vector<double> shown = HeightsIn(window, ground.heights(), grid);
  Json json{{"x0_m", grid.x0_m + window.x0 * grid.cell_m},
            {"y0_m", grid.y0_m + window.y0 * grid.cell_m},
            {"cell_m", grid.cell_m * window.stride},
            {"columns", window.columns},
            {"rows", window.rows},
            {"heights", payload.AddChannel(shown, kHeightQuantum_m)},
            {"changes", Json::array()}};
  for (std::size_t i = 1; i < run.ground.size(); ++i) {
    ground.AdvanceTo(run.ground[i].time_s);
    std::vector<double> cells, heights;
    for (const std::uint32_t cell : run.ground[i].value.cells) {
      const auto vertex = window.VertexOf(cell, grid.nx);
      if (!vertex || cell >= ground.heights().size()) continue;
      const double height_m = Rounded(ground.heights()[cell] * grid.step_m);
      if (height_m == shown[*vertex]) continue;
      shown[*vertex] = height_m;
      cells.push_back(*vertex);
      heights.push_back(height_m);
    }
    if (cells.empty()) continue;
    json["changes"].push_back({{"sample", run.SampleAt(run.ground[i].time_s)},
                               {"cells", payload.AddChannel(cells, 1.0)},
                               {"heights", payload.AddChannel(heights, kHeightQuantum_m)}});
  }
  return json;
}

}  // namespace dockyard
