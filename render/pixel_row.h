// Pixels of an image, one by one and as rows of arrays that loops go through side by side.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "render/flat_view.h"

namespace dockyard {

/// Tan-plane points of the corners of a camera's pixels: (width + 1) x (height + 1), row by row
/// from the corner of the top left pixel.
struct PixelGrid {
  int width = 0, height = 0;
  std::vector<float> x, y;
};

/// Tan-plane points of the corners of a pixel: 00, 10, 01, 11.
using PixelCorners = std::array<Tan, 4>;

/// Rays of a pixel: the middles of its quarters.
inline constexpr int kRays = 4;

/// So many pixels of the board are shaded at once at most.
inline constexpr int kBoardAtOnce = 64;

struct Pixel {
  Tan middle, along, down;  // its point, and how that changes along and down the image
  int column, row;          // of the image

  float blur() const {  // half its width
    return 0.25f * (std::abs(along.x) + std::abs(along.y) + std::abs(down.x) + std::abs(down.y));
  }
  Tan Ray(int k) const { return At((k & 1) ? 0.25f : -0.25f, (k & 2) ? 0.25f : -0.25f); }
  PixelCorners corners() const {
    return {At(-0.5f, -0.5f), At(0.5f, -0.5f), At(-0.5f, 0.5f), At(0.5f, 0.5f)};
  }

 private:
  Tan At(float u, float v) const {
    return {middle.x + u * along.x + v * down.x, middle.y + u * along.y + v * down.y};
  }
};

struct PixelRow {
  explicit PixelRow(int width)
      : x(width), y(width), along_x(width), along_y(width), down_x(width), down_y(width) {}

  void Fill(const PixelGrid& grid, int row) {
    number = row;
    const std::size_t first = static_cast<std::size_t>(row) * (grid.width + 1);
    const float *ax = &grid.x[first], *ay = &grid.y[first];
    const float *bx = ax + grid.width + 1, *by = ay + grid.width + 1;
    for (int i = 0; i < grid.width; ++i) x[i] = 0.25f * (ax[i] + ax[i + 1] + bx[i] + bx[i + 1]);
    for (int i = 0; i < grid.width; ++i) y[i] = 0.25f * (ay[i] + ay[i + 1] + by[i] + by[i + 1]);
    for (int i = 0; i < grid.width; ++i) {
      along_x[i] = 0.5f * (ax[i + 1] + bx[i + 1] - ax[i] - bx[i]);
      along_y[i] = 0.5f * (ay[i + 1] + by[i + 1] - ay[i] - by[i]);
    }
    for (int i = 0; i < grid.width; ++i) {
      down_x[i] = 0.5f * (bx[i] + bx[i + 1] - ax[i] - ax[i + 1]);
      down_y[i] = 0.5f * (by[i] + by[i + 1] - ay[i] - ay[i + 1]);
    }
  }
  Pixel At(int i) const {
    return {.middle = {x[i], y[i]},
            .along = {along_x[i], along_y[i]},
            .down = {down_x[i], down_y[i]},
            .column = i,
            .row = number};
  }

  std::vector<float> x, y, along_x, along_y, down_x, down_y;
  int number = 0;  // of the image's rows
};

}  // namespace dockyard
