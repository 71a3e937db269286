#include "controller/motion/disc_grid.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/polygon.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr int kMostCellsAlong = 512;  // a side; 6 MB at most
constexpr int kWideCells = 64;        // more are not entered into each
constexpr int kMostPieces = 64;       // of an arc
constexpr double kSlack = 1e-6;       // of lengths and in metres, beyond all rounding

double FarthestCorner(const Polygon& polygon) {
  double far_m = 0.0;
  for (const Vector2d& corner : polygon) far_m = std::max(far_m, corner.norm());
  return far_m;
}

}  // namespace

double ReachOf(const RoverPlan& rover) {
  double reach_m = 0.0;
  for (const Polygon& part : rover.body) reach_m = std::max(reach_m, FarthestCorner(part));
  const double wheel_m = rover.wheels.empty() ? 0.0 : FarthestCorner(WheelOutline(rover));
  for (const WheelPlan& wheel : rover.wheels) {
    reach_m = std::max(reach_m, wheel.p_RW.norm() + wheel_m);
  }
  return reach_m;
}

DiscGrid::DiscGrid(std::vector<Disc> discs) : discs_(std::move(discs)) {
  if (discs_.empty()) return;
  Vector2d high = low_ = discs_.front().centre;
  for (const Disc& disc : discs_) {
    low_ = low_.cwiseMin(disc.centre);
    high = high.cwiseMax(disc.centre);
  }
  const Vector2d size = high - low_;
  // About one disc a cell, where they are spread evenly.
  const double even_m = std::sqrt(size.x() * size.y() / static_cast<double>(discs_.size()));
  cell_m_ = std::max({even_m, size.maxCoeff() / kMostCellsAlong, 1e-3});
  nx_ = static_cast<int>(size.x() / cell_m_) + 1;
  ny_ = static_cast<int>(size.y() / cell_m_) + 1;
  cells_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const Cells box = CellsAround(discs_[i].centre, discs_[i].radius_m);
    if ((box.high_x - box.low_x + 1) * (box.high_y - box.low_y + 1) > kWideCells) {
      wide_.push_back(i);
      continue;
    }
    for (int y = box.low_y; y <= box.high_y; ++y) {
      for (int x = box.low_x; x <= box.high_x; ++x) {
        cells_[static_cast<std::size_t>(y * nx_ + x)].push_back(i);
      }
    }
  }
}

// Of a square. The cells at the border also hold the discs beyond it.
DiscGrid::Cells DiscGrid::CellsAround(const Vector2d& middle, double half_m) const {
  const auto index = [&](double at_m, int count) {
    return static_cast<int>(std::clamp(std::floor(at_m / cell_m_), 0.0, count - 1.0));
  };
  const Vector2d from = middle - low_;
  return {index(from.x() - half_m, nx_), index(from.y() - half_m, ny_),
          index(from.x() + half_m, nx_), index(from.y() + half_m, ny_)};
}

std::vector<Disc> DiscGrid::Near(const std::vector<Arc>& path, double reach_m) const {
  if (discs_.empty()) return {};
  std::vector<std::size_t> found = wide_;
  const auto Add = [&](const Vector2d& middle, double half_m) {
    const Cells box = CellsAround(middle, half_m);
    for (int y = box.low_y; y <= box.high_y; ++y) {
      for (int x = box.low_x; x <= box.high_x; ++x) {
        const auto& cell = cells_[static_cast<std::size_t>(y * nx_ + x)];
        found.insert(found.end(), cell.begin(), cell.end());
      }
    }
  };
  if (path.empty()) Add({0, 0}, reach_m + kSlack);
  Pose2 X_AR;
  for (const Arc& arc : path) {
    // Pieces about as long as the rover; all of a piece lies within half its length of its middle.
    const double length_m = std::abs(arc.length_m);
    const double wanted = length_m / std::max(2.0 * reach_m, 1e-3);
    const int pieces = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, 1.0 * kMostPieces));
    const double half_m = 0.5 * length_m / pieces;
    for (int i = 0; i < pieces; ++i) {
      const Pose2 middle = Advance(X_AR, Part(arc, (i + 0.5) / pieces));
      Add({middle.x, middle.y}, (half_m + reach_m) * (1.0 + kSlack) + kSlack * (1.0 + length_m));
    }
    X_AR = Advance(X_AR, arc);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Disc> near;
  near.reserve(found.size());
  for (const std::size_t i : found) near.push_back(discs_[i]);
  return near;
}

}  // namespace dockyard
