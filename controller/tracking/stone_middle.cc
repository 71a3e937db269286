#include "controller/tracking/stone_middle.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSigmaOfMad = 1.4826;  // of a normal distribution, over the median deviation
constexpr int kPasses = 12;             // of the plane's fit; it moves by micrometres after eight
constexpr double kKept = 2.5;           // sigmas from the plane that still are ground
// Length over width from which a stone has a longer side: cells of 5 mm on a stone of 3 cm tell no
// less. Assumed, 1.1-1.4.
constexpr double kLong = 1.2;

struct Cell {
  Vector2d p_E{0, 0};
  double height_m = 0.0, sigma_m = 0.0;
  double above_m = 0.0;  // the ground
};

// Known cells within a circle.
std::vector<Cell> CellsAbout(const ElevationMap& map, const Vector2d& p_E, double radius_m) {
  std::vector<Cell> cells;
  for (int iy = 0; iy < map.ny; ++iy) {
    for (int ix = 0; ix < map.nx; ++ix) {
      const auto place = static_cast<std::size_t>(iy * map.nx + ix);
      const Vector2d at(map.x0_m + ix * map.cell_m, map.y0_m + iy * map.cell_m);
      if (map.points[place] == 0 || (at - p_E).norm() > radius_m) continue;
      cells.push_back(
          {at, static_cast<double>(map.height_m[place]), static_cast<double>(map.sigma_m[place])});
    }
  }
  return cells;
}

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Ground {
  Vector3d plane{0, 0, 0};  // about the window's middle
  double sigma_m = 0.0;
};

// Weights fall as the deviation grows, and are none for what stands out: least absolute deviations,
// which half of the cells cannot mislead, then least squares on the ground alone.
Ground FitGround(const std::vector<Cell>& cells, const Vector2d& middle) {
  Ground ground;
  for (int pass = 0; pass < kPasses; ++pass) {
    const bool squares = pass > kPasses / 2;
    Eigen::Matrix3d normal = 1e-12 * Eigen::Matrix3d::Identity();
    Vector3d right = Vector3d::Zero();
    for (const Cell& cell : cells) {
      const Vector3d row(1.0, cell.p_E.x() - middle.x(), cell.p_E.y() - middle.y());
      const double off = std::abs(cell.height_m - row.dot(ground.plane));
      double weight = 1.0;
      if (squares) {
        weight = off < kKept * ground.sigma_m ? 1.0 : 0.0;
      } else if (pass > 0) {
        weight = 1.0 / std::max(off, 1e-4);
      }
      normal += weight * row * row.transpose();
      right += weight * row * cell.height_m;
    }
    ground.plane = normal.ldlt().solve(right);
    std::vector<double> off;
    for (const Cell& cell : cells) {
      const Vector3d row(1.0, cell.p_E.x() - middle.x(), cell.p_E.y() - middle.y());
      off.push_back(std::abs(cell.height_m - row.dot(ground.plane)));
    }
    // Not below a map without noise.
    ground.sigma_m = std::max(kSigmaOfMad * MedianOf(std::move(off)), 1e-5);
  }
  return ground;
}

// Cells by the top that they belong to, as water that sinks lays tops bare and joins them.
class Tops {
 public:
  Tops(const std::vector<Cell>& cells, const StoneMiddleSettings& with, double sigma_m)
      : cells_(cells), parent_(cells.size(), -1), peak_(cells.size(), 0) {
    for (int i = 0; i < static_cast<int>(cells.size()); ++i) Lay(i, with, sigma_m);
  }
  // Indices of cells, one list for each top.
  std::vector<std::vector<int>> Lists() {
    std::vector<std::vector<int>> lists(cells_.size());
    for (int i = 0; i < static_cast<int>(cells_.size()); ++i) {
      lists[static_cast<std::size_t>(Root(i))].push_back(i);
    }
    std::erase_if(lists, [](const auto& list) { return list.empty(); });
    return lists;
  }

 private:
  int Root(int i) const {
    while (parent_[static_cast<std::size_t>(i)] != i) i = parent_[static_cast<std::size_t>(i)];
    return i;
  }
  double PeakOf(int root) const {
    return cells_[static_cast<std::size_t>(peak_[static_cast<std::size_t>(root)])].above_m;
  }
  // Cells come from the highest down.
  void Lay(int i, const StoneMiddleSettings& with, double sigma_m) {
    const auto at = static_cast<std::size_t>(i);
    parent_[at] = peak_[at] = i;
    int mine = i;
    // The nearest first, so that a cell between two stones goes to the nearer.
    std::vector<std::pair<double, int>> beside;
    for (int j = 0; j < i; ++j) {
      const double away_m = (cells_[static_cast<std::size_t>(j)].p_E - cells_[at].p_E).norm();
      if (away_m <= with.link_m) beside.emplace_back(away_m, j);
    }
    std::sort(beside.begin(), beside.end());
    for (const auto& [away_m, j] : beside) {
      const int other = Root(j);
      if (other == mine) continue;
      const double lower = std::min(PeakOf(other), PeakOf(mine));
      const double rise = lower - cells_[at].above_m;
      const bool apart =
          mine != i && rise > with.saddle_share * lower && rise > with.least_sigmas * sigma_m;
      if (apart) continue;
      const bool higher = PeakOf(other) >= PeakOf(mine);
      const int to = higher ? other : mine, from = higher ? mine : other;
      parent_[static_cast<std::size_t>(from)] = to;
      mine = to;
    }
  }

  const std::vector<Cell>& cells_;  // sorted by height, the highest first
  std::vector<int> parent_, peak_;
};

struct Stone {
  Vector2d p_E{0, 0};
  double top_m = 0.0, half_length_m = 0.0, half_width_m = 0.0;
  std::optional<double> heading_rad;
  bool cut = false;  // by the border of what was looked at
};

Stone StoneOf(const std::vector<Cell>& cells, const std::vector<int>& list,
              const StoneMiddleSettings& with, const Vector2d& about, double radius_m) {
  Stone stone;
  // The lists' cells come from the highest down; single cells may be wild.
  const std::size_t second = std::min<std::size_t>(1, list.size() - 1);
  stone.top_m = cells[static_cast<std::size_t>(list[second])].above_m;
  const double from_m = with.upper_share * stone.top_m;
  double weight = 0.0, count = 0.0;
  Vector2d plain = Vector2d::Zero(), heavy = Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const int i : list) {
    const Cell& cell = cells[static_cast<std::size_t>(i)];
    stone.cut |= (cell.p_E - about).norm() > radius_m - with.link_m;
    if (cell.above_m < from_m) continue;
    // None at the lower end, where a cell more or less must not matter.
    const double w = cell.above_m - from_m;
    weight += w;
    heavy += w * cell.p_E;
    ++count;
    plain += cell.p_E;
    squares += cell.p_E * cell.p_E.transpose();
  }
  stone.p_E = weight > 0.0 ? Vector2d(heavy / weight) : Vector2d(plain / count);
  plain /= count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread(squares / count -
                                                              plain * plain.transpose());
  // An ellipse's second moment along a half axis is a quarter of its square.
  stone.half_width_m = 2.0 * std::sqrt(std::max(0.0, spread.eigenvalues()[0]));
  stone.half_length_m = 2.0 * std::sqrt(std::max(0.0, spread.eigenvalues()[1]));
  if (stone.half_length_m > kLong * stone.half_width_m) {
    const Vector2d along = spread.eigenvectors().col(1);
    stone.heading_rad = std::atan(along.y() / (along.x() == 0.0 ? 1e-12 : along.x()));
  }
  return stone;
}

// Whether enough of the window and of what is about it is known.
bool IsSeen(const std::vector<Cell>& cells, const Vector2d& p_E, double cell_m,
            const StoneMiddleSettings& with) {
  // At 1 m rows of pixels are two cells apart, and a stone hides what is behind it. Assumed,
  // 0.1-0.4.
  constexpr double kKnown = 0.2;
  constexpr std::size_t kLeastCells = 16;
  const auto within = std::count_if(cells.begin(), cells.end(), [&](const Cell& cell) {
    return (cell.p_E - p_E).norm() < with.window_m;
  });
  const auto Places = [&](double radius_m) {
    return kPi * radius_m * radius_m / (cell_m * cell_m);
  };
  return cells.size() >= kLeastCells &&
         static_cast<double>(cells.size()) >= kKnown * Places(with.window_m + with.ring_m) &&
         static_cast<double>(within) >= kKnown * Places(with.window_m);
}

struct Candidates {
  std::vector<Stone> near;  // with their middles in the window, the nearest first
  bool beyond = false;      // something else reaches into it
};

// Of the cells that stand out, the highest first.
Candidates CandidatesOf(const std::vector<Cell>& cells, const Vector2d& p_E, double sigma_m,
                        const StoneMiddleSettings& with) {
  Candidates candidates;
  const double radius_m = with.window_m + with.ring_m;
  const auto Away = [&](const Vector2d& p) { return (p - p_E).norm(); };
  for (const std::vector<int>& list : Tops(cells, with, sigma_m).Lists()) {
    if (static_cast<int>(list.size()) < with.least_cells) continue;
    const Stone stone = StoneOf(cells, list, with, p_E, radius_m);
    if (Away(stone.p_E) <= with.window_m && !stone.cut) {
      candidates.near.push_back(stone);
      continue;
    }
    candidates.beyond |= std::any_of(list.begin(), list.end(), [&](int i) {
      return Away(cells[static_cast<std::size_t>(i)].p_E) <= with.window_m;
    });
  }
  std::sort(candidates.near.begin(), candidates.near.end(),
            [&](const Stone& a, const Stone& b) { return Away(a.p_E) < Away(b.p_E); });
  return candidates;
}

}  // namespace

StoneMiddle FindStone(const ElevationMap& map, const Vector2d& p_E,
                      const StoneMiddleSettings& with) {
  StoneMiddle found;
  std::vector<Cell> cells = CellsAbout(map, p_E, with.window_m + with.ring_m);
  if (!IsSeen(cells, p_E, map.cell_m, with)) return found;
  const Ground ground = FitGround(cells, p_E);
  found.ground = {ground.plane.x() - ground.plane.tail<2>().dot(p_E), ground.plane.y(),
                  ground.plane.z()};
  found.sigma_m = ground.sigma_m;
  for (Cell& cell : cells) {
    cell.above_m = cell.height_m - found.ground.dot(Vector3d(1.0, cell.p_E.x(), cell.p_E.y()));
  }
  std::erase_if(cells, [&](const Cell& cell) {
    const double sigma_m = std::max(ground.sigma_m, cell.sigma_m);
    return cell.above_m < with.least_height_m || cell.above_m < with.least_sigmas * sigma_m;
  });
  std::stable_sort(cells.begin(), cells.end(),
                   [](const Cell& a, const Cell& b) { return a.above_m > b.above_m; });
  const auto [near, beyond] = CandidatesOf(cells, p_E, ground.sigma_m, with);
  if (near.empty()) {
    found.verdict = beyond ? StoneVerdict::kBorder : StoneVerdict::kFlat;
    return found;
  }
  const Stone& stone = near.front();
  const bool several =
      near.size() > 1 && (near[1].p_E - p_E).norm() - (stone.p_E - p_E).norm() < with.apart_m;
  found.verdict = several ? StoneVerdict::kSeveral : StoneVerdict::kFound;
  found.p_E = stone.p_E;
  found.height_m = stone.top_m;
  found.half_length_m = stone.half_length_m;
  found.half_width_m = stone.half_width_m;
  found.heading_rad = stone.heading_rad;
  return found;
}

}  // namespace dockyard
