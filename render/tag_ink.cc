#include "render/tag_ink.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

/// A convex polygon: a quadrangle cut by up to four lines has at most eight corners.
struct Polygon {
  std::array<Eigen::Vector2d, 8> corners;
  std::size_t count = 0;
};

double TwiceArea(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.count];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(sum);
}

/// The part between two limits along an axis (Sutherland and Hodgman, CACM 17(1), 1974).
Polygon Between(const Polygon& polygon, int axis, double low, double high) {
  Polygon kept = polygon;
  for (const auto& [limit, sign] : {std::pair(low, 1.0), {high, -1.0}}) {
    const Polygon whole = kept;
    kept.count = 0;
    for (std::size_t i = 0; i < whole.count; ++i) {
      const Eigen::Vector2d &a = whole.corners[i], &b = whole.corners[(i + 1) % whole.count];
      const double in_a = sign * (a[axis] - limit), in_b = sign * (b[axis] - limit);
      if (in_a >= 0.0 && kept.count < 8) kept.corners[kept.count++] = a;
      if (in_a * in_b < 0.0 && kept.count < 8) {
        kept.corners[kept.count++] = a + in_a / (in_a - in_b) * (b - a);
      }
    }
  }
  return kept;
}

}  // namespace

TagInk::TagInk(const SquareTag& tag) : cells_(tag.cells), p_BT_(tag.p_BT) {
  // Counter-clockwise for the viewer is towards -y, for y points down: see OnBoard.
  const double c = std::cos(tag.rotation) / tag.cell_m();
  const double s = std::sin(tag.rotation) / tag.cell_m();
  cells_from_board_ << c, -s, s, c;
  radius_m_ = std::sqrt(0.5) * tag.printed_m();
}

double TagInk::Share(const std::array<Eigen::Vector2f, 4>& footprint_B) const {
  Polygon pixel;  // in cells, from the top left of the printed square
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Eigen::Vector2f& corner : footprint_B) {
    const Eigen::Vector2d cell = cells_from_board_ * (corner.cast<double>() - p_BT_) +
                                 Eigen::Vector2d::Constant(0.5 * cells_.across);
    pixel.corners[pixel.count++] = cell;
    low = low.cwiseMin(cell);
    high = high.cwiseMax(cell);
  }
  if (low.maxCoeff() >= cells_.across || high.minCoeff() <= 0.0) return 0.0;
  const auto cell = [&](double at) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, cells_.across - 1.0));
  };
  const int first = cell(low.x()), last = cell(high.x());
  int blacks = 0, all = 0;
  for (int row = cell(low.y()); row <= cell(high.y()); ++row) {
    for (int column = first; column <= last; ++column) {
      blacks += cells_.IsBlack(column, row);
      ++all;
    }
  }
  if (blacks == 0) return 0.0;
  if (blacks == all && low.minCoeff() >= 0.0 && high.maxCoeff() <= cells_.across) return 1.0;
  double black = 0.0;
  for (int row = cell(low.y()); row <= cell(high.y()); ++row) {
    const Polygon strip = Between(pixel, 1, row, row + 1);
    for (int column = first; column <= last; ++column) {
      if (!cells_.IsBlack(column, row)) continue;
      int end = column + 1;
      while (end <= last && cells_.IsBlack(end, row)) ++end;
      black += TwiceArea(Between(strip, 0, column, end));
      column = end;
    }
  }
  return std::clamp(black / TwiceArea(pixel), 0.0, 1.0);
}

}  // namespace dockyard
