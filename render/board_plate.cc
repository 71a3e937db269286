#include "render/board_plate.h"

#include <algorithm>
#include <cmath>

#include "render/bent_plate.h"

namespace dockyard {
namespace {

constexpr int kStrips = 96;  // across the hole, closer together towards its sides

/// A strip between two verticals: from the line y_top to the line y_bottom (y is down).
void AddStrip(SurfaceMesh& plate, const Eigen::Vector2d& x, const Eigen::Vector2d& y_top,
              const Eigen::Vector2d& y_bottom) {
  if (x[1] <= x[0] || (y_bottom - y_top).maxCoeff() <= 0.0) return;
  const auto first = static_cast<std::uint32_t>(plate.vertices.size());
  const Eigen::Vector3f to_beholder(0.0f, 0.0f, -1.0f);
  for (const Eigen::Vector2d& p :
       {Eigen::Vector2d(x[0], y_bottom[0]), Eigen::Vector2d(x[1], y_bottom[1]),
        Eigen::Vector2d(x[1], y_top[1]), Eigen::Vector2d(x[0], y_top[0])}) {
    plate.vertices.push_back(
        {Eigen::Vector3f(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0f), to_beholder,
         1.0f});
  }
  for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
    plate.indices.push_back(first + corner);
  }
}

// Squares of the print. Their chords stay within a thousandth of the bow.
SurfaceMesh BentMesh(const BoardView& view) {
  constexpr int kSquares = 32;  // a side
  const BentPlate bent(view);
  const Eigen::Vector2d size(view.board.width_m, view.board.height_m);
  SurfaceMesh plate;
  for (int row = 0; row <= kSquares; ++row) {
    for (int column = 0; column <= kSquares; ++column) {
      const Eigen::Vector2d p =
          (Eigen::Vector2d(column, row) / kSquares - Eigen::Vector2d::Constant(0.5))
              .cwiseProduct(size);
      plate.vertices.push_back({bent.At(p).cast<float>(), bent.Normal(p).cast<float>(), 1.0f});
    }
  }
  for (std::uint32_t row = 0; row < kSquares; ++row) {
    for (std::uint32_t column = 0; column < kSquares; ++column) {
      const std::uint32_t top = row * (kSquares + 1) + column, low = top + kSquares + 1;
      for (const std::uint32_t corner : {low, low + 1, top + 1, low, top + 1, top}) {
        plate.indices.push_back(corner);
      }
    }
  }
  return plate;
}

}  // namespace

SurfaceMesh BoardPlate(const BoardView& view) {
  if (view.flatness_m != 0.0) return BentMesh(view);
  const double half_width = 0.5 * view.board.width_m, half_height = 0.5 * view.board.height_m;
  const Eigen::Vector2d top = Eigen::Vector2d::Constant(-half_height);
  const Eigen::Vector2d bottom = Eigen::Vector2d::Constant(half_height);
  SurfaceMesh plate;
  if (view.hole_radius_m <= 0.0) {
    AddStrip(plate, {-half_width, half_width}, top, bottom);
    return plate;
  }
  const auto across = [&](double x) { return std::clamp(x, -half_width, half_width); };
  const auto down = [&](double y) { return std::clamp(y, -half_height, half_height); };
  const double radius = view.hole_radius_m;
  // Slightly over the strips beside them, or single rays pass through where the corners differ.
  constexpr double kOver_m = 1e-4;
  AddStrip(plate, {-half_width, across(view.p_BH.x() - radius + kOver_m)}, top, bottom);
  AddStrip(plate, {across(view.p_BH.x() + radius - kOver_m), half_width}, top, bottom);
  for (int i = 0; i < kStrips; ++i) {
    Eigen::Vector2d x, above, below;
    for (int side = 0; side < 2; ++side) {
      const double angle = kPi * (i + side) / kStrips;
      x[side] = across(view.p_BH.x() - radius * std::cos(angle));
      const double offset = x[side] - view.p_BH.x();
      const double rise = std::sqrt(std::max(0.0, radius * radius - offset * offset));
      above[side] = down(view.p_BH.y() - rise);
      below[side] = down(view.p_BH.y() + rise);
    }
    AddStrip(plate, x, top, above);
    AddStrip(plate, x, below, bottom);
  }
  return plate;
}

}  // namespace dockyard
