#include "render/view_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/two_widths.h"

namespace dockyard {
namespace {

// Loops of few arrays, which the compiler takes four at a time.

// Whole columns or lines of a view to which a ray of each pixel points.
void Steps(const float* __restrict at, const float* __restrict along, const float* __restrict down,
           float u, float v, float origin, float per_tan, int count, float* __restrict steps) {
  for (int i = 0; i < count; ++i) {
    const float step = (at[i] + u * along[i] + v * down[i] - origin) * per_tan;
    steps[i] = static_cast<float>(static_cast<int>(step));
  }
}

// Exact: a view has fewer than 2^24 rays.
void Places(const float* __restrict column, const float* __restrict line, float width, int count,
            int* __restrict places) {
  for (int i = 0; i < count; ++i) places[i] = static_cast<int>(line[i] * width + column[i]);
}

void Add(const float* __restrict steps, bool afresh, int count, float* __restrict sum) {
  if (afresh) {
    std::copy(steps, steps + count, sum);
  } else {
    for (int i = 0; i < count; ++i) sum[i] += steps[i];
  }
}

}  // namespace

DOCKYARD_TWO_WIDTHS
void ViewSampler::Find(const PixelRow& row, int first, int last, RowRays& rays) const {
  const int count = last - first;
  for (int k = 0; k < kRays; ++k) {
    const float u = (k & 1) ? 0.25f : -0.25f, v = (k & 2) ? 0.25f : -0.25f;
    float *column = &rays.columns[k][first], *line = &rays.lines[k][first];
    Steps(&row.x[first], &row.along_x[first], &row.down_x[first], u, v, x0_, sx_, count, column);
    Steps(&row.y[first], &row.along_y[first], &row.down_y[first], u, v, y0_, sy_, count, line);
    Places(column, line, static_cast<float>(view_.width), count, &rays.at[k][first]);
    Add(column, k == 0, count, &rays.from_x[first]);
    Add(line, k == 0, count, &rays.from_y[first]);
  }
  const float per_x = 0.25f * per_sx_, per_y = 0.25f * per_sy_;
  const float middle_x = 0.5f * per_sx_ + x0_, middle_y = 0.5f * per_sy_ + y0_;
  for (int i = first; i < last; ++i) rays.from_x[i] = rays.from_x[i] * per_x + middle_x;
  for (int i = first; i < last; ++i) rays.from_y[i] = rays.from_y[i] * per_y + middle_y;
}

DOCKYARD_TWO_WIDTHS
void ViewSampler::Mark(const PixelRow& row, int first, int last, const TanRect& part, bool inside,
                       std::uint8_t* marks) {
  const auto left = static_cast<float>(part.left), right = static_cast<float>(part.right);
  const auto top = static_cast<float>(part.top), bottom = static_cast<float>(part.bottom);
  const float* __restrict x = row.x.data();
  const float* __restrict y = row.y.data();
  const float* __restrict ax = row.along_x.data();
  const float* __restrict ay = row.along_y.data();
  const float* __restrict dx = row.down_x.data();
  const float* __restrict dy = row.down_y.data();
  const float side = inside ? -0.5f : 0.5f;
  for (int i = first; i < last; ++i) {
    const float hx = side * (std::abs(ax[i]) + std::abs(dx[i]));
    const float hy = side * (std::abs(ay[i]) + std::abs(dy[i]));
    const bool mark =
        (x[i] + hx >= left) & (x[i] - hx < right) & (y[i] + hy >= top) & (y[i] - hy < bottom);
    marks[i] = mark ? 1 : 0;
  }
}

DOCKYARD_TWO_WIDTHS
void ViewSampler::MeanFrom(const RowRays& rays, int first, int count, float* __restrict x,
                           float* __restrict y) const {
  const auto mean = [&](const std::array<std::vector<float>, kRays>& steps, float per, float origin,
                        float* __restrict out) {
    const float *a = &steps[0][first], *b = &steps[1][first];
    const float *c = &steps[2][first], *d = &steps[3][first];
    const auto from = [&](float step) { return (step + 0.5f) * per + origin; };
    for (int i = 0; i < count; ++i) {
      out[i] = (from(a[i]) + from(b[i]) + from(c[i]) + from(d[i])) * 0.25f;
    }
  };
  mean(rays.columns, per_sx_, x0_, x);
  mean(rays.lines, per_sy_, y0_, y);
}

DOCKYARD_TWO_WIDTHS
void ViewSampler::FindMiddles(const PixelRow& row, int count, int* __restrict places) const {
  const float* __restrict x = row.x.data();
  const float* __restrict y = row.y.data();
  const float x0 = x0_, y0 = y0_, sx = sx_, sy = sy_;
  const int width = view_.width;
  for (int i = 0; i < count; ++i) {
    const int column = static_cast<int>((x[i] - x0) * sx),
              line = static_cast<int>((y[i] - y0) * sy);
    places[i] = line * width + column;
  }
}

void ViewSampler::Hold(const PixelRow& row, int count, std::uint8_t* held) const {
  Mark(row, 0, count, view_.rect, true, held);
}

void ViewSampler::HaveThin(const ThinLayer& layer, const PixelRow& row, int first, int last,
                           std::uint8_t* have) const {
  // Bodies spread over a pixel of the view by interpolation.
  const TanRect part{.left = x0_ + (static_cast<float>(layer.x) - 1.0f) * per_sx_,
                     .top = y0_ + (static_cast<float>(layer.y) - 1.0f) * per_sy_,
                     .right = x0_ + (static_cast<float>(layer.x + layer.width) + 1.0f) * per_sx_,
                     .bottom = y0_ + (static_cast<float>(layer.y + layer.height) + 1.0f) * per_sy_};
  Mark(row, first, last, part, false, have);
}

}  // namespace dockyard
