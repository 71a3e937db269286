#include "controller/tracking/stones_in_map.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/median.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr double kSigmaOfMad = 1.4826;  // of a normal distribution, over the median deviation
constexpr int kPasses = 12;             // of the ground's fit; it moves by micrometres after eight
constexpr double kKept = 2.5;           // sigmas from the ground that still are ground
// Length over width from which a stone has a longer side: cells of 5 mm on a stone of 3 cm tell no
// less. Assumed, 1.1-1.4.
constexpr double kLong = 1.2;

using Terms = Eigen::Matrix<double, 6, 1>;

Terms TermsAt(const Vector2d& p, GroundShape shape) {
  Terms terms = Terms::Zero();
  terms.head<3>() << 1.0, p.x(), p.y();
  if (shape == GroundShape::kCurved) terms.tail<3>() << p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
  return terms;
}

struct HighCell {
  Vector2d p_E{0, 0};
  double above_m = 0.0;  // the ground
};

// Cells by the top that they belong to, as water that sinks lays tops bare and joins them.
class Tops {
 public:
  Tops(const std::vector<HighCell>& cells, const StoneMiddleSettings& with, double sigma_m)
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

  const std::vector<HighCell>& cells_;  // sorted by height, the highest first
  std::vector<int> parent_, peak_;
};

StoneTop StoneOf(const std::vector<HighCell>& cells, const std::vector<int>& list,
                 const StoneMiddleSettings& with, const Vector2d& about, double radius_m) {
  StoneTop stone;
  stone.nearest_m = radius_m;
  // The lists' cells come from the highest down; single cells may be wild.
  const std::size_t second = std::min<std::size_t>(1, list.size() - 1);
  stone.top_m = cells[static_cast<std::size_t>(list[second])].above_m;
  const double from_m = with.upper_share * stone.top_m;
  double weight = 0.0, count = 0.0;
  Vector2d plain = Vector2d::Zero(), heavy = Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const int i : list) {
    const HighCell& cell = cells[static_cast<std::size_t>(i)];
    const double away_m = (cell.p_E - about).norm();
    stone.nearest_m = std::min(stone.nearest_m, away_m);
    stone.cut |= away_m > radius_m - with.link_m;
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

}  // namespace

double GroundFit::Height(const Vector2d& p_E) const {
  return terms.dot(TermsAt(p_E - middle, GroundShape::kCurved));
}

std::vector<MapCell> CellsAbout(const ElevationMap& map, const Vector2d& p_E, double radius_m) {
  std::vector<MapCell> cells;
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

GroundFit FitGround(const std::vector<MapCell>& cells, const Vector2d& middle, GroundShape shape) {
  GroundFit ground{.middle = middle};
  std::vector<Terms> rows;
  for (const MapCell& cell : cells) rows.push_back(TermsAt(cell.p_E - middle, shape));
  for (int pass = 0; pass < kPasses; ++pass) {
    const bool squares = pass > kPasses / 2;
    Eigen::Matrix<double, 6, 6> normal = 1e-12 * Eigen::Matrix<double, 6, 6>::Identity();
    Terms right = Terms::Zero();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double off = std::abs(cells[i].height_m - rows[i].dot(ground.terms));
      double weight = 1.0;
      if (squares) {
        weight = off < kKept * ground.sigma_m ? 1.0 : 0.0;
      } else if (pass > 0) {
        weight = 1.0 / std::max(off, 1e-4);
      }
      normal += weight * rows[i] * rows[i].transpose();
      right += weight * rows[i] * cells[i].height_m;
    }
    ground.terms = normal.ldlt().solve(right);
    std::vector<double> off;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      off.push_back(std::abs(cells[i].height_m - rows[i].dot(ground.terms)));
    }
    // Not below a map without noise.
    const double median_m = off.empty() ? 0.0 : Median(std::move(off));
    ground.sigma_m = std::max(kSigmaOfMad * median_m, 1e-5);
  }
  return ground;
}

std::vector<StoneTop> TopsAbout(const std::vector<MapCell>& cells, const GroundFit& ground,
                                const Vector2d& p_E, double radius_m,
                                const StoneMiddleSettings& with) {
  std::vector<HighCell> high;
  for (const MapCell& cell : cells) {
    const double above_m = cell.height_m - ground.Height(cell.p_E);
    const double sigma_m = std::max(ground.sigma_m, cell.sigma_m);
    if (above_m < with.least_height_m || above_m < with.least_sigmas * sigma_m) continue;
    high.push_back({cell.p_E, above_m});
  }
  std::stable_sort(high.begin(), high.end(),
                   [](const HighCell& a, const HighCell& b) { return a.above_m > b.above_m; });
  std::vector<StoneTop> stones;
  for (const std::vector<int>& list : Tops(high, with, ground.sigma_m).Lists()) {
    if (static_cast<int>(list.size()) < with.least_cells) continue;
    stones.push_back(StoneOf(high, list, with, p_E, radius_m));
  }
  return stones;
}

}  // namespace dockyard
