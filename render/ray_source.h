// The rays of a flat view that belong to a pixel, as many as the view is dense. No GL.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "render/flat_view.h"
#include "render/pixel_row.h"
#include "render/view_sampler.h"

namespace dockyard {

/// Views of colour cameras are rolled against the image by this angle, and the rays with them: else
/// an edge along the pixels' rows would move by whole distances of rays. Its tangent, the square of
/// the golden section, keeps rays from lying in line with one another.
inline constexpr double kViewTurn_rad = 0.364864;

/// Between the tan plane of the image and that of its views.
struct ViewTurn {
  float c = static_cast<float>(std::cos(kViewTurn_rad));
  float s = static_cast<float>(std::sin(kViewTurn_rad));

  Tan ToView(Tan t) const { return {c * t.x + s * t.y, -s * t.x + c * t.y}; }
  Tan ToImage(Tan t) const { return {c * t.x - s * t.y, s * t.x + c * t.y}; }
  /// x and y of many at once.
  void ToView(const std::vector<float>& x, const std::vector<float>& y, std::vector<float>& to_x,
              std::vector<float>& to_y) const {
    for (std::size_t i = 0; i < x.size(); ++i) to_x[i] = c * x[i] + s * y[i];
    for (std::size_t i = 0; i < x.size(); ++i) to_y[i] = c * y[i] - s * x[i];
  }
  void ToView(const PixelRow& row, PixelRow& to) const {
    ToView(row.x, row.y, to.x, to.y);
    ToView(row.along_x, row.along_y, to.along_x, to.along_y);
    ToView(row.down_x, row.down_y, to.down_x, to.down_y);
    to.number = row.number;
  }
};

/// A view and how many of its rays a pixel asks for: rays x rays.
struct RaySource {
  const FlatView& view;
  ViewSampler sampler;
  int rays;
  float x0, y0, sx, sy, per_sx, per_sy;

  RaySource(const FlatView& v, int n)
      : view(v),
        sampler(v),
        rays(n),
        x0(static_cast<float>(v.rect.left)),
        y0(static_cast<float>(v.rect.top)),
        sx(static_cast<float>(v.width / (v.rect.right - v.rect.left))),
        sy(static_cast<float>(v.height / (v.rect.bottom - v.rect.top))),
        per_sx(1.0f / sx),
        per_sy(1.0f / sy) {}

  /// Calls for each ray of a pixel: where it points, the hit, and where the view's ray points; all
  /// in the view's tan plane.
  template <typename Visit>
  void Each(const Pixel& pixel, const Visit& visit) const {
    const float step = 1.0f / static_cast<float>(rays);
    for (int j = 0; j < rays; ++j) {
      const float v = (static_cast<float>(j) + 0.5f) * step - 0.5f;
      for (int i = 0; i < rays; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) * step - 0.5f;
        const Tan ray{pixel.middle.x + u * pixel.along.x + v * pixel.down.x,
                      pixel.middle.y + u * pixel.along.y + v * pixel.down.y};
        const int column = static_cast<int>((ray.x - x0) * sx);
        const int line = static_cast<int>((ray.y - y0) * sy);
        const Tan from{(static_cast<float>(column) + 0.5f) * per_sx + x0,
                       (static_cast<float>(line) + 0.5f) * per_sy + y0};
        visit(ray, view.seen[static_cast<std::size_t>(line) * view.width + column], from);
      }
    }
  }
};

/// Rays of one pixel that met one thing: the ground, or one object.
struct Met {
  int object = -1;
  float count = 0.0f, code = 0.0f;
  Tan ray, from;                    // in the view's tan plane; after Average in the image's
  Eigen::Vector3f normal{0, 0, 0};  // their sum

  void Add(float c, Tan r, Tan f) {
    ++count;
    code += c;
    ray = {ray.x + r.x, ray.y + r.y};
    from = {from.x + f.x, from.y + f.y};
  }
  void Average(const ViewTurn& turn) {  // sums to means
    const float per = 1.0f / count;
    code *= per;
    ray = turn.ToImage({ray.x * per, ray.y * per});
    from = turn.ToImage({from.x * per, from.y * per});
    normal *= per;
  }
};

}  // namespace dockyard
