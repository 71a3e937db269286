#include "render/compose.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/board_ink.h"
#include "render/ground_mesh.h"
#include "render/object_shader.h"
#include "render/sky_shader.h"

namespace dockyard {
namespace {

constexpr int kRays = 4;  // of a pixel: the middles of its quarters

// A flat view's own pixels from the tan plane.
struct Sampler {
  explicit Sampler(const FlatView& v)
      : view(v),
        sx(static_cast<float>(v.width / (v.rect.right - v.rect.left))),
        sy(static_cast<float>(v.height / (v.rect.bottom - v.rect.top))),
        per_sx(1.0f / sx),
        per_sy(1.0f / sy),
        x0(static_cast<float>(v.rect.left)),
        y0(static_cast<float>(v.rect.top)) {}

  int Column(float tan_x) const { return static_cast<int>((tan_x - x0) * sx); }
  int Row(float tan_y) const { return static_cast<int>((tan_y - y0) * sy); }
  const Seen& At(int x, int y) const {
    return view.seen[static_cast<std::size_t>(y) * view.width + x];
  }
  // Whether any thin body may touch the pixels from (x1, y1) to (x2, y2).
  bool HasThin(int x1, int y1, int x2, int y2) const {
    return x2 >= view.thin_x && x1 < view.thin_x + view.thin_width && y2 >= view.thin_y &&
           y1 < view.thin_y + view.thin_height;
  }
  // Bilinear, for the bodies are drawn hardly wider than the rays are apart.
  Thin ThinAt(Tan tan) const {
    const float x = (tan.x - x0) * sx - 0.5f, y = (tan.y - y0) * sy - 0.5f;
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    Thin sum;
    for (int k = 0; k < 4; ++k) {
      const int tx = ix + (k & 1) - view.thin_x, ty = iy + (k >> 1) - view.thin_y;
      if (tx < 0 || ty < 0 || tx >= view.thin_width || ty >= view.thin_height) continue;
      const float weight = ((k & 1) ? fx : 1.0f - fx) * ((k & 2) ? fy : 1.0f - fy);
      Add(view.thin[static_cast<std::size_t>(ty) * view.thin_width + tx], weight, sum);
    }
    return sum;
  }
  static void Add(const Thin& thin, float weight, Thin& sum) {
    sum.to_sun += weight * thin.to_sun;
    sum.to_zenith += weight * thin.to_zenith;
    sum.inverse_depth += weight * thin.inverse_depth;
    sum.cover += weight * thin.cover;
  }
  // Where the ray of a pixel of the view looks.
  Tan Centre(const int (&at)[2]) const {
    return {(static_cast<float>(at[0]) + 0.5f) * per_sx + x0,
            (static_cast<float>(at[1]) + 0.5f) * per_sy + y0};
  }
  bool Holds(Tan tan) const {
    const float x = (tan.x - x0) * sx, y = (tan.y - y0) * sy;
    return x >= 0.0f && y >= 0.0f && x < static_cast<float>(view.width) &&
           y < static_cast<float>(view.height);
  }

  const FlatView& view;
  float sx, sy, per_sx, per_sy, x0, y0;
};

// The pixels of one row: where their middles look, and how that changes along and down the picture.
struct Row {
  explicit Row(int width)
      : x(width), y(width), along_x(width), along_y(width), down_x(width), down_y(width) {}

  void Fill(const PixelGrid& grid, int row) {
    const std::size_t first = static_cast<std::size_t>(row) * (grid.width + 1);
    const float *ax = &grid.x[first], *ay = &grid.y[first];
    const float *bx = ax + grid.width + 1, *by = ay + grid.width + 1;
    for (int i = 0; i < grid.width; ++i) {
      x[i] = 0.25f * (ax[i] + ax[i + 1] + bx[i] + bx[i + 1]);
      y[i] = 0.25f * (ay[i] + ay[i + 1] + by[i] + by[i + 1]);
      along_x[i] = 0.5f * (ax[i + 1] + bx[i + 1] - ax[i] - bx[i]);
      along_y[i] = 0.5f * (ay[i + 1] + by[i + 1] - ay[i] - by[i]);
      down_x[i] = 0.5f * (bx[i] + bx[i + 1] - ax[i] - ax[i + 1]);
      down_y[i] = 0.5f * (by[i] + by[i + 1] - ay[i] - ay[i + 1]);
    }
  }

  std::vector<float> x, y, along_x, along_y, down_x, down_y;
};

struct Pixel {
  Tan middle, along, down;
  int turn;

  float blur() const {  // half its width
    return 0.25f * (std::abs(along.x) + std::abs(along.y) + std::abs(down.x) + std::abs(down.y));
  }
  Tan Ray(int k) const {
    const float u = (k & 1) ? 0.25f : -0.25f, v = (k & 2) ? 0.25f : -0.25f;
    return {middle.x + u * along.x + v * down.x, middle.y + u * along.y + v * down.y};
  }
  PixelCorners corners() const {
    PixelCorners c;
    for (int k = 0; k < 4; ++k) {
      const float u = (k & 1) ? 0.5f : -0.5f, v = (k & 2) ? 0.5f : -0.5f;
      c[k] = {middle.x + u * along.x + v * down.x, middle.y + u * along.y + v * down.y};
    }
    return c;
  }
};

// Scatters neighbouring pixels (Jimenez, SIGGRAPH 2014, interleaved gradient noise).
int Turn(int x, int y) {
  const float a = 0.06711056f * static_cast<float>(x) + 0.00583715f * static_cast<float>(y);
  const float b = 52.9829189f * (a - static_cast<float>(static_cast<int>(a)));
  const float c = b - static_cast<float>(static_cast<int>(b));
  return std::min(static_cast<int>(c * SunShadow::kTurns), SunShadow::kTurns - 1);
}

// One camera's picture.
class Composer {
 public:
  Composer(const FlatView& wide, const FlatView* close, const Lit& lit, const Pose3& X_WC,
           Channel channel)
      : wide_(wide),
        sky_(lit.scene, X_WC, channel),
        objects_(lit.scene, lit.shadow, X_WC, channel) {
    if (close) close_.emplace(*close);
    if (HasGround(lit.scene.ground)) {
      ground_.emplace(lit.ground, lit.scene, lit.shadow, X_WC, channel);
    }
    if (lit.scene.board.board.width_m > 0.0) board_.emplace(lit.scene, X_WC, channel);
  }

  float operator()(const Pixel& pixel) const {
    const Sampler& view = close_ && HeldClose(pixel) ? *close_ : wide_;
    int at[kRays][2];
    Seen seen[kRays];
    Tan from[kRays];  // each met what it met there, up to half a ray's distance off the pixel's own
    for (int k = 0; k < kRays; ++k) {
      const Tan tan = pixel.Ray(k);
      at[k][0] = view.Column(tan.x);
      at[k][1] = view.Row(tan.y);
      seen[k] = view.At(at[k][0], at[k][1]);
      from[k] = view.Centre(at[k]);
    }
    const float least =
        std::min(std::min(seen[0].code, seen[1].code), std::min(seen[2].code, seen[3].code));
    const float most =
        std::max(std::max(seen[0].code, seen[1].code), std::max(seen[2].code, seen[3].code));
    float radiance = 0.0f;
    if (least > 0.0f && most < kBoardCode) {
      const float code = 0.25f * (seen[0].code + seen[1].code + seen[2].code + seen[3].code);
      radiance = (*ground_)({pixel.middle, Mean(from)}, code, pixel.along, pixel.down, pixel.turn);
    } else if (least == 0.0f && most == 0.0f) {
      radiance = sky_(pixel.middle);
    } else {
      radiance = Mixed(pixel, seen, from);
    }
    return view.HasThin(at[0][0], at[0][1], at[3][0], at[3][1]) ? Behind(view, pixel, radiance)
                                                                : radiance;
  }

  /// 1/z of what the middle of a pixel shows, thin bodies aside.
  float InverseDepthAt(Tan middle) const {
    return InverseDepth(wide_.At(wide_.Column(middle.x), wide_.Row(middle.y)).code);
  }

 private:
  bool HeldClose(const Pixel& pixel) const {
    if (!close_->Holds(pixel.middle)) return false;
    const PixelCorners c = pixel.corners();
    return close_->Holds(c[0]) && close_->Holds(c[1]) && close_->Holds(c[2]) && close_->Holds(c[3]);
  }

  // Rays of one pixel that met objects, the board, or different things.
  float Mixed(const Pixel& pixel, const Seen (&seen)[kRays], const Tan (&from)[kRays]) const {
    float radiance = 0.0f;
    Met grounds, boards;
    float skies = 0.0f;
    for (int k = 0; k < kRays; ++k) {
      if (IsObject(seen[k].code)) {
        radiance += Facet(pixel, seen, from, k);
      } else if (IsBoard(seen[k].code)) {
        boards.Add(seen[k].code, pixel.Ray(k), from[k]);
      } else if (IsSky(seen[k].code)) {
        ++skies;
      } else {
        grounds.Add(seen[k].code, pixel.Ray(k), from[k]);
      }
    }
    if (grounds.count > 0.0f) {
      radiance += grounds.count * (*ground_)({grounds.MeanRay(), grounds.MeanFrom()},
                                             grounds.code / grounds.count, pixel.along, pixel.down,
                                             pixel.turn);
    }
    if (boards.count > 0.0f) {
      const float share = objects_.BoardShare(boards.MeanRay(), pixel.blur(), pixel.turn);
      radiance += boards.count * (*board_)(pixel.corners(), share);
    }
    if (skies > 0.0f) radiance += skies * sky_(pixel.middle);
    return radiance * (1.0f / kRays);
  }

  // Rays that met one thing.
  struct Met {
    float count = 0.0f, code = 0.0f;
    Tan ray, from;

    void Add(float c, Tan r, Tan f) {
      ++count;
      code += c;
      ray = {ray.x + r.x, ray.y + r.y};
      from = {from.x + f.x, from.y + f.y};
    }
    Tan MeanRay() const { return {ray.x / count, ray.y / count}; }
    Tan MeanFrom() const { return {from.x / count, from.y / count}; }
  };

  // All rays that met the facet of ray k share one look, in their middle; the first of them has it.
  float Facet(const Pixel& pixel, const Seen (&seen)[kRays], const Tan (&from)[kRays],
              int k) const {
    Met met;
    for (int j = 0; j < kRays; ++j) {
      if (!IsObject(seen[j].code) || seen[j].object != seen[k].object) continue;
      if (j < k) return 0.0f;
      met.Add(seen[j].code, from[j], from[j]);
    }
    const Seen middle{.object = seen[k].object, .code = met.code / met.count};
    return met.count * objects_(middle, met.MeanFrom(), pixel.blur(), pixel.turn);
  }

  static Tan Mean(const Tan (&t)[kRays]) {
    return {0.25f * (t[0].x + t[1].x + t[2].x + t[3].x),
            0.25f * (t[0].y + t[1].y + t[2].y + t[3].y)};
  }

  // The same behind thin bodies.
  float Behind(const Sampler& view, const Pixel& pixel, float radiance) const {
    Thin sum;
    for (int k = 0; k < kRays; ++k) Sampler::Add(view.ThinAt(pixel.Ray(k)), 0.25f, sum);
    if (sum.cover <= 0.0f) return radiance;
    return radiance * (1.0f - sum.cover) +
           objects_.OfThin(sum, pixel.middle, pixel.blur(), pixel.turn);
  }

  Sampler wide_;
  std::optional<Sampler> close_;
  SkyShader sky_;
  ObjectShader objects_;
  std::optional<GroundShader> ground_;
  std::optional<BoardShader> board_;
};

}  // namespace

RadianceImage Compose(const PixelGrid& grid, const FlatView& wide, const FlatView* close,
                      const Lit& lit, const Pose3& X_WC, Channel channel, bool with_depth) {
  RadianceImage image{
      .width = grid.width, .height = grid.height, .values = {}, .inverse_depth = {}};
  image.values.resize(static_cast<std::size_t>(grid.width) * grid.height);
  const Composer composer(wide, close, lit, X_WC, channel);
  Row row(grid.width);
  for (int y = 0; y < grid.height; ++y) {
    row.Fill(grid, y);
    float* out = &image.values[static_cast<std::size_t>(y) * grid.width];
    for (int x = 0; x < grid.width; ++x) {
      if (with_depth) image.inverse_depth.push_back(composer.InverseDepthAt({row.x[x], row.y[x]}));
      out[x] = composer({.middle = {row.x[x], row.y[x]},
                         .along = {row.along_x[x], row.along_y[x]},
                         .down = {row.down_x[x], row.down_y[x]},
                         .turn = Turn(x, y)});
    }
  }
  return image;
}

}  // namespace dockyard
