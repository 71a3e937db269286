#include "controller/vision/tags/tag_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

constexpr double kReach = 3.5;  // standard deviations; 5e-4 of a Gaussian lies beyond
constexpr int kMostCells = 16;  // a side, of any family here

/// Shares of the blur in each cell of a row, with their derivatives by place and by sigma.
struct Shares {
  int first = 0, last = -1;
  std::array<double, kMostCells> share{}, by_place{}, by_sigma{};
};

Shares SharesOf(double place, double sigma, int across) {
  Shares shares;
  shares.first = std::max(0, static_cast<int>(std::floor(place - kReach * sigma)));
  shares.last = std::min(across - 1, static_cast<int>(std::floor(place + kReach * sigma)));
  struct Edge {
    double below, density, scaled;
  };
  const auto edge = [&](int at) {
    const double z = (at - place) / sigma;
    const double density = std::exp(-0.5 * z * z) / (std::sqrt(2.0 * kPi) * sigma);
    return Edge{0.5 * std::erfc(-z / std::sqrt(2.0)), density, z * density};
  };
  if (shares.first > shares.last) return shares;
  Edge low = edge(shares.first);
  for (int i = shares.first; i <= shares.last; ++i) {
    const Edge high = edge(i + 1);
    const auto k = static_cast<std::size_t>(i);
    shares.share[k] = high.below - low.below;
    shares.by_place[k] = low.density - high.density;
    shares.by_sigma[k] = low.scaled - high.scaled;
    low = high;
  }
  return shares;
}

}  // namespace

Blackness BlacknessAt(const TagCells& cells, const Eigen::Vector2d& at,
                      const Eigen::Vector2d& sigma) {
  const double half = 0.5 * cells.across;
  const Shares x = SharesOf(at.x() + half, sigma.x(), cells.across);
  const Shares y = SharesOf(at.y() + half, sigma.y(), cells.across);
  Blackness black;
  for (int row = y.first; row <= y.last; ++row) {
    double share = 0.0, by_x = 0.0, by_sigma = 0.0;
    for (int column = x.first; column <= x.last; ++column) {
      if (!cells.IsBlack(column, row)) continue;
      const auto k = static_cast<std::size_t>(column);
      share += x.share[k];
      by_x += x.by_place[k];
      by_sigma += x.by_sigma[k];
    }
    const auto k = static_cast<std::size_t>(row);
    black.share += share * y.share[k];
    black.slope += Eigen::Vector2d(by_x * y.share[k], share * y.by_place[k]);
    black.by_sigma += Eigen::Vector2d(by_sigma * y.share[k], share * y.by_sigma[k]);
  }
  return black;
}

}  // namespace dockyard
