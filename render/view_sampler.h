// Finds a flat view's rays from the tan plane. No GL.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "render/flat_view.h"
#include "render/pixel_row.h"

namespace dockyard {

/// For pixels of a row: which rays of a view are theirs, and the middle of those rays' directions.
struct RowRays {
  explicit RowRays(int width) : from_x(width), from_y(width) {
    for (int k = 0; k < kRays; ++k) {
      at[k].resize(width);
      columns[k].resize(width);
      lines[k].resize(width);
    }
  }
  std::array<std::vector<int>, kRays> at;  // places in FlatView::seen
  std::vector<float> from_x, from_y;
  std::array<std::vector<float>, kRays> columns, lines;  // of each ray in the view; whole numbers
};

class ViewSampler {
 public:
  explicit ViewSampler(const FlatView& v)
      : view_(v),
        sx_(static_cast<float>(v.width / (v.rect.right - v.rect.left))),
        sy_(static_cast<float>(v.height / (v.rect.bottom - v.rect.top))),
        per_sx_(1.0f / sx_),
        per_sy_(1.0f / sy_),
        x0_(static_cast<float>(v.rect.left)),
        y0_(static_cast<float>(v.rect.top)) {}

  const Seen& At(int place) const { return view_.seen[static_cast<std::size_t>(place)]; }
  const Seen& At(Tan tan) const { return At(Row(tan.y) * view_.width + Column(tan.x)); }
  void Prefetch(int place) const { __builtin_prefetch(&At(place)); }
  /// The direction of a pixel's k-th ray of the view.
  Tan From(const RowRays& rays, int k, int x) const {
    return {(rays.columns[k][x] + 0.5f) * per_sx_ + x0_, (rays.lines[k][x] + 0.5f) * per_sy_ + y0_};
  }

  /// Calls for each of rays x rays of a pixel: where it points, the hit, and where the view's ray
  /// points.
  template <typename Visit>
  void Each(const Pixel& pixel, int rays, const Visit& visit) const {
    const float step = 1.0f / static_cast<float>(rays);
    for (int j = 0; j < rays; ++j) {
      const float v = (static_cast<float>(j) + 0.5f) * step - 0.5f;
      for (int i = 0; i < rays; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) * step - 0.5f;
        const Tan ray{pixel.middle.x + u * pixel.along.x + v * pixel.down.x,
                      pixel.middle.y + u * pixel.along.y + v * pixel.down.y};
        const int column = Column(ray.x), line = Row(ray.y);
        visit(ray, At(line * view_.width + column),
              Tan{(static_cast<float>(column) + 0.5f) * per_sx_ + x0_,
                  (static_cast<float>(line) + 0.5f) * per_sy_ + y0_});
      }
    }
  }

  /// The rays of pixels first to last - 1, all of which the view holds.
  void Find(const PixelRow& row, int first, int last, RowRays& rays) const;
  /// Of pixels first to first + count - 1: the mean of From of a pixel's four rays.
  void MeanFrom(const RowRays& rays, int first, int count, float* x, float* y) const;
  /// Of count pixels from the row's first: the place of the ray in each one's middle.
  void FindMiddles(const PixelRow& row, int count, int* places) const;
  /// Which of count pixels have their whole footprint in the view: 1, else 0.
  void Hold(const PixelRow& row, int count, std::uint8_t* held) const;
  /// Which of pixels first to last - 1 a thin body may touch.
  void HaveThin(const ThinLayer& layer, const PixelRow& row, int first, int last,
                std::uint8_t* have) const;
  const std::vector<ThinLayer>& layers() const { return view_.layers; }
  /// Bilinear, for the bodies are drawn hardly wider than the rays are apart.
  Thin ThinAt(const ThinLayer& layer, Tan tan) const {
    const float x = (tan.x - x0_) * sx_ - 0.5f, y = (tan.y - y0_) * sy_ - 0.5f;
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    Thin sum;
    for (int k = 0; k < 4; ++k) {
      const int tx = ix + (k & 1) - layer.x, ty = iy + (k >> 1) - layer.y;
      if (tx < 0 || ty < 0 || tx >= layer.width || ty >= layer.height) continue;
      const float weight = ((k & 1) ? fx : 1.0f - fx) * ((k & 2) ? fy : 1.0f - fy);
      sum.Add(layer.thin[static_cast<std::size_t>(ty) * layer.width + tx], weight);
    }
    return sum;
  }

 private:
  int Column(float tan_x) const { return static_cast<int>((tan_x - x0_) * sx_); }
  int Row(float tan_y) const { return static_cast<int>((tan_y - y0_) * sy_); }
  // Whether footprints lie in (inside) or touch a part of the view, in its pixels.
  static void Mark(const PixelRow& row, int first, int last, const TanRect& part, bool inside,
                   std::uint8_t* marks);

  const FlatView& view_;
  float sx_, sy_, per_sx_, per_sy_, x0_, y0_;
};

}  // namespace dockyard
