#include "render/compose_colour.h"

#include <algorithm>
#include <optional>

#include "render/colour_shader.h"
#include "render/ray_source.h"

namespace dockyard {
namespace {

enum class Kind : std::uint8_t { kGround, kSky, kMixed };

class Composer {
 public:
  Composer(int width, const FlatView& wide, const FlatView* close, const ColourLit& lit,
           const Pose3& X_WC)
      : row_(width),
        turned_(width),
        held_(width, 0),
        have_(width, 0),
        kind_(width),
        known_x_(width),
        known_y_(width),
        code_(width),
        colour_(width),
        rays_(width),
        wide_(wide, kWideRays),
        bits_(BitsFor(lit.scene.objects.size())),
        shader_(lit, X_WC) {
    if (close) close_.emplace(*close, kCloseRays);
  }

  void Row(const PixelGrid& grid, int y, const PixelSpan& span, std::array<float*, 3> sums) {
    row_.Fill(grid, y);
    turn_.ToView(row_, turned_);
    if (close_) close_->sampler.Hold(turned_, grid.width, held_.data());
    wide_.sampler.Find(turned_, span.first, span.last, rays_);
    for (int x = span.first; x < span.last; ++x) {
      if (held_[x]) {
        Ask(x);
      } else {
        AskWide(x);
      }
    }
    for (int from = span.first, to; from < span.last; from = to) {
      to = from + 1;
      if (kind_[from] == Kind::kGround) {
        while (to < span.last && kind_[to] == kind_[from] && to - from < GroundShader::kAtOnce) {
          ++to;
        }
        shader_.Ground({.x = &row_.x[from],
                        .y = &row_.y[from],
                        .known_x = &known_x_[from],
                        .known_y = &known_y_[from],
                        .inverse_depth = &code_[from],
                        .along_x = &row_.along_x[from],
                        .along_y = &row_.along_y[from],
                        .down_x = &row_.down_x[from],
                        .down_y = &row_.down_y[from],
                        .count = to - from,
                        .column = from,
                        .row = row_.number},
                       &colour_[from]);
      } else if (kind_[from] == Kind::kSky) {
        colour_[from] = shader_.Sky({row_.x[from], row_.y[from]});
      } else {
        colour_[from] = Mixed(from);
      }
    }
    for (const RaySource* source : {&wide_, close_ ? &*close_ : nullptr}) {
      if (source) AddThin(*source, span, source != &wide_);
    }
    for (int x = span.first; x < span.last; ++x) sums[0][x] += colour_[x].r;
    for (int x = span.first; x < span.last; ++x) sums[1][x] += colour_[x].g;
    for (int x = span.first; x < span.last; ++x) sums[2][x] += colour_[x].b;
  }

 private:
  const RaySource& SourceOf(int x) const { return close_ && held_[x] ? *close_ : wide_; }

  // The wide view's rays have been found, all at once.
  void AskWide(int x) {
    static_assert(kWideRays * kWideRays == kRays);
    const ViewSampler& view = wide_.sampler;
    const float a = view.At(rays_.at[0][x]).code, b = view.At(rays_.at[1][x]).code;
    const float c = view.At(rays_.at[2][x]).code, d = view.At(rays_.at[3][x]).code;
    const float least = std::min(std::min(a, b), std::min(c, d));
    const float most = std::max(std::max(a, b), std::max(c, d));
    kind_[x] = KindOf(least, most);
    code_[x] = 0.25f * (a + b + c + d);
    SetKnown(x, {rays_.from_x[x], rays_.from_y[x]});
  }

  void SetKnown(int x, Tan in_view) {
    const Tan known = turn_.ToImage(in_view);
    known_x_[x] = known.x;
    known_y_[x] = known.y;
  }

  static Kind KindOf(float least, float most) {
    return least > 0.0f ? Kind::kGround : least == 0.0f && most == 0.0f ? Kind::kSky : Kind::kMixed;
  }

  void Ask(int x) {
    float least = 1e9f, most = -1e9f, code = 0.0f, count = 0.0f;
    Tan from_sum;
    close_->Each(turned_.At(x), [&](Tan, const Seen& seen, Tan from) {
      least = std::min(least, seen.code);
      most = std::max(most, seen.code);
      code += seen.code;
      from_sum = {from_sum.x + from.x, from_sum.y + from.y};
      ++count;
    });
    kind_[x] = KindOf(least, most);
    code_[x] = code / count;
    SetKnown(x, {from_sum.x / count, from_sum.y / count});
  }

  // Rays that met different things, or objects.
  Rgb Mixed(int x) const {
    constexpr int kMost = kCloseRays * kCloseRays;
    const Pixel pixel = row_.At(x);
    std::array<Met, kMost> objects;
    int kinds = 0;
    Met ground;
    float skies = 0.0f, count = 0.0f;
    SourceOf(x).Each(turned_.At(x), [&](Tan ray, const Seen& seen, Tan from) {
      ++count;
      if (IsSky(seen.code)) {
        ++skies;
      } else if (IsObject(seen.code)) {
        const int object = ObjectOf(seen, bits_);
        int k = 0;
        while (k < kinds && objects[k].object != object) ++k;
        if (k == kinds) objects[kinds++].object = object;
        objects[k].Add(-seen.code, ray, from);
        objects[k].normal += UnpackNormal(seen, bits_);
      } else {
        ground.Add(seen.code, ray, from);
      }
    });
    Rgb sum;
    for (int k = 0; k < kinds; ++k) {
      const float rays = objects[k].count;
      objects[k].Average(turn_);
      sum.Add(shader_.OfObject(objects[k], pixel), rays);
    }
    if (ground.count > 0.0f) {
      const float rays = ground.count;
      ground.Average(turn_);
      sum.Add(shader_.GroundPart(ground, pixel), rays);
    }
    if (skies > 0.0f) sum.Add(shader_.Sky(pixel.middle), skies);
    const float per = 1.0f / count;
    return {sum.r * per, sum.g * per, sum.b * per};
  }

  // Cables before all that.
  void AddThin(const RaySource& source, const PixelSpan& span, bool held) {
    for (std::size_t body = 0; body < source.view.layers.size(); ++body) {
      const ThinLayer& layer = source.view.layers[body];
      if (layer.width == 0) continue;
      source.sampler.HaveThin(layer, turned_, span.first, span.last, have_.data());
      for (int x = span.first; x < span.last; ++x) {
        const bool mine = (held_[x] != 0) == held;
        if (have_[x] && mine) Cover(source, layer, body, x);
      }
    }
  }

  void Cover(const RaySource& source, const ThinLayer& layer, std::size_t body, int x) {
    const Pixel pixel = row_.At(x);
    Thin sum;
    for (int k = 0; k < kRays; ++k) {
      sum.Add(source.sampler.ThinAt(layer, turn_.ToView(pixel.Ray(k))), 0.25f);
    }
    if (sum.cover > 0.0f) colour_[x] = shader_.OfThin(body, sum, pixel, colour_[x]);
  }

  ViewTurn turn_;
  PixelRow row_, turned_;                  // in the tan plane of the image, of its views
  std::vector<std::uint8_t> held_, have_;  // by the close view; by a thin body
  std::vector<Kind> kind_;
  std::vector<float> known_x_, known_y_, code_;  // means of a pixel's rays
  std::vector<Rgb> colour_;
  RowRays rays_;
  RaySource wide_;
  std::optional<RaySource> close_;
  SeenBits bits_;
  ColourShader shader_;
};

}  // namespace

void ComposeColour(const PixelGrid& grid, const std::vector<PixelSpan>& spans, const FlatView& wide,
                   const FlatView* close, const ColourLit& lit, const Pose3& X_WC,
                   std::array<RadianceImage, 3>& sum) {
  Composer composer(grid.width, wide, close, lit, X_WC);
  for (int y = 0; y < grid.height; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * grid.width;
    composer.Row(grid, y, spans[static_cast<std::size_t>(y)],
                 {&sum[0].values[at], &sum[1].values[at], &sum[2].values[at]});
  }
}

}  // namespace dockyard
