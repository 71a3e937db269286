#include "render/compose.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "controller/base/two_widths.h"
#include "render/view_sampler.h"
#include "render/view_turn.h"

namespace dockyard {
namespace {

// The kind of surface that all rays of a pixel met; kFacet: one facet of an object.
enum class Kind : std::uint8_t { kMixed, kGround, kSky, kBoard, kFacet };

// A view and how many of its rays a pixel asks for along either side.
struct RaySource {
  ViewSampler sampler;
  int rays;
};

// One camera's image, row by row. Views of colour cameras are turned against the image.
template <typename Value>
class Composer {
  static constexpr bool kColour = SceneShader<Value>::kColour;
  static constexpr int kMostRays = kColour ? kCloseRays * kCloseRays : kRays;
  static_assert(kWideRays * kWideRays == kRays);

 public:
  Composer(int width, const FlatView& wide, const FlatView* close, int close_rays,
           SceneShader<Value> shader)
      : row_(width),
        turned_(kColour ? width : 0),
        rays_(width),
        inverse_depth_(width),
        kind_(width),
        held_(width, 0),
        thin_(width, 0),
        wide_{ViewSampler(wide), kWideRays},
        has_thin_(wide.HasThin() || (close && close->HasThin())),
        by_facets_(!kColour || !shader.sunlit()),
        shader_(std::move(shader)) {
    if (close) close_.emplace(ViewSampler(*close), close_rays);
  }

  void Row(const PixelGrid& grid, int y, const PixelSpan& span, Value* radiance) {
    row_.Fill(grid, y);
    if constexpr (kColour) turn_.ToView(row_, turned_);
    if (close_) close_->sampler.Hold(InView(), grid.width, held_.data());
    for (int first = span.first, last; first < span.last; first = last) {
      last = first + 1;
      while (last < span.last && held_[last] == held_[first]) ++last;
      Part(held_[first] ? *close_ : wide_, first, last, radiance);
    }
  }
  /// 1/z of the surfaces in the middles of the last row's pixels, thin bodies aside.
  void InverseDepths(int count, float* inverse_depth) {
    int* middles = rays_.at[0].data();
    wide_.sampler.FindMiddles(row_, count, middles);
    for (int x = 0; x < count; ++x) {
      inverse_depth[x] = InverseDepth(wide_.sampler.At(middles[x]).code);
    }
  }

 private:
  // The row in the tan plane of the views, and from there to the image's.
  const PixelRow& InView() const { return kColour ? turned_ : row_; }
  Tan ToImage(Tan t) const {
    if constexpr (kColour) return turn_.ToImage(t);
    return t;
  }
  Tan ToView(Tan t) const {
    if constexpr (kColour) return turn_.ToView(t);
    return t;
  }

  // Pixels first to last - 1, all from one view.
  void Part(const RaySource& source, int first, int last, Value* radiance) {
    if (source.rays == kWideRays) {
      AskFour(source.sampler, first, last);
    } else {
      for (int x = first; x < last; ++x) AskMany(source, x);
    }
    for (int x = first; kColour && x < last; ++x) {
      const Tan known = ToImage({rays_.from_x[x], rays_.from_y[x]});
      rays_.from_x[x] = known.x;
      rays_.from_y[x] = known.y;
    }
    for (int from = first, to; from < last; from = to) {
      to = from + 1;
      while (to < last && kind_[to] == kind_[from]) ++to;
      if (kind_[from] == Kind::kGround) {
        shader_.Ground({.x = &row_.x[from],
                        .y = &row_.y[from],
                        .known_x = &rays_.from_x[from],
                        .known_y = &rays_.from_y[from],
                        .inverse_depth = &inverse_depth_[from],
                        .along_x = &row_.along_x[from],
                        .along_y = &row_.along_y[from],
                        .down_x = &row_.down_x[from],
                        .down_y = &row_.down_y[from],
                        .count = to - from,
                        .column = from,
                        .row = row_.number},
                       radiance + from);
      } else if (kind_[from] == Kind::kSky) {
        for (int x = from; x < to; ++x) radiance[x] = shader_.Sky({row_.x[x], row_.y[x]});
      } else if (kind_[from] == Kind::kBoard) {
        Boards(source, from, to, radiance);
      } else if (kind_[from] == Kind::kFacet) {
        Facets(source.sampler, from, to, radiance);
      } else {
        for (int x = from; x < to; ++x) radiance[x] = Mixed(source, x);
      }
    }
    if (has_thin_) AddThin(source.sampler, first, last, radiance);
  }

  static Kind KindOf(float least, float most) {
    return least > 0.0f && most < kBoardCode ? Kind::kGround
           : least == 0.0f && most == 0.0f   ? Kind::kSky
           : least >= kBoardCode             ? Kind::kBoard
                                             : Kind::kMixed;
  }

  void AskFour(const ViewSampler& view, int first, int last) {
    view.Find(InView(), first, last, rays_);
    for (int x = first; x < last; ++x) {
      constexpr int kAhead = 24;
      if (x + kAhead < last) {
        view.Prefetch(rays_.at[1][x + kAhead]);
        view.Prefetch(rays_.at[3][x + kAhead]);
      }
      const auto &s0 = view.At(rays_.at[0][x]), &s1 = view.At(rays_.at[1][x]);
      const auto &s2 = view.At(rays_.at[2][x]), &s3 = view.At(rays_.at[3][x]);
      const float a = s0.code, b = s1.code, c = s2.code, d = s3.code;
      const float least = std::min(std::min(a, b), std::min(c, d));
      const float most = std::max(std::max(a, b), std::max(c, d));
      inverse_depth_[x] = 0.25f * (a + b + c + d);
      kind_[x] = KindOf(least, most);
      if (by_facets_ && most < 0.0f && s0.object == s1.object && s0.object == s2.object &&
          s0.object == s3.object) {
        kind_[x] = Kind::kFacet;
      }
    }
  }

  void AskMany(const RaySource& source, int x) {
    float least = 1e9f, most = -1e9f, code = 0.0f, count = 0.0f;
    Tan from_sum;
    source.sampler.Each(InView().At(x), source.rays, [&](Tan, const Seen& seen, Tan from) {
      least = std::min(least, seen.code);
      most = std::max(most, seen.code);
      code += seen.code;
      from_sum = {from_sum.x + from.x, from_sum.y + from.y};
      ++count;
    });
    kind_[x] = KindOf(least, most);
    inverse_depth_[x] = code / count;
    rays_.from_x[x] = from_sum.x / count;
    rays_.from_y[x] = from_sum.y / count;
  }

  // Calls for each ray of a pixel: where it points, the hit, and where the view's ray points; all
  // in the view's tan plane.
  template <typename Visit>
  void Each(const RaySource& source, int x, const Visit& visit) const {
    const Pixel pixel = InView().At(x);
    if (source.rays != kWideRays) return source.sampler.Each(pixel, source.rays, visit);
    for (int k = 0; k < kRays; ++k) {
      visit(pixel.Ray(k), source.sampler.At(rays_.at[k][x]), source.sampler.From(rays_, k, x));
    }
  }

  // Pixels of which all rays met boards.
  void Boards(const RaySource& source, int from, int to, Value* radiance) const {
    if (shader_.boards() == 1) return shader_.Board(0, row_, from, to - from, radiance + from);
    for (int x = from; x < to; ++x) radiance[x] = Mixed(source, x);
  }

  // Pixels each of which met one facet: as Mixed, to the bit for a grey camera, but side by side.
  // A colour camera's sun is left to Mixed.
  void Facets(const ViewSampler& view, int from, int to, Value* radiance) const {
    FacetRow facets;
    std::array<std::uint32_t, kFacetsAtOnce> words;
    for (int first = from; first < to; first += kFacetsAtOnce) {
      const int count = std::min(kFacetsAtOnce, to - first);
      view.MeanFrom(rays_, first, count, facets.from_x.data(), facets.from_y.data());
      for (int i = 0; i < count; ++i) {
        if constexpr (kColour) {
          const Tan from = ToImage({facets.from_x[i], facets.from_y[i]});
          facets.from_x[i] = from.x;
          facets.from_y[i] = from.y;
        }
        facets.inverse_depth[i] = -inverse_depth_[first + i];
        words[i] = view.At(rays_.at[0][first + i]).object;
      }
      shader_.OfFacets(words.data(), facets, row_, first, count, radiance + first);
    }
  }

  // Rays of one pixel that met objects, or different things.
  Value Mixed(const RaySource& source, int x) const {
    const Pixel pixel = row_.At(x);
    std::array<Met, kMostRays> things;
    int kinds = 0;
    Met ground;
    float skies = 0.0f, count = 0.0f;
    Each(source, x, [&](Tan ray, const Seen& seen, Tan from) {
      ++count;
      if (IsSky(seen.code)) {
        ++skies;
        return;
      }
      const bool object = IsObject(seen.code), board = IsBoard(seen.code);
      const float inverse_depth = InverseDepth(seen.code);
      if (!object && !board) return ground.Add(inverse_depth, ray, from);
      const std::uint32_t thing = kColour && object
                                      ? static_cast<std::uint32_t>(ObjectOf(seen, shader_.bits()))
                                      : seen.object;
      int k = 0;
      while (k < kinds && (things[k].thing != thing || things[k].of_board != board)) ++k;
      if (k == kinds) ++kinds;
      Met& met = things[k];
      met.thing = thing;
      met.of_board = board;
      if (object && (kColour || met.count == 0.0f)) met.normal += NormalOf(seen.object);
      met.Add(inverse_depth, ray, from);
    });
    Value sum{};
    for (int k = 0; k < kinds; ++k) {
      if (things[k].of_board) continue;
      Average(things[k]);
      const std::uint32_t thing = things[k].thing;
      const std::size_t object = kColour ? thing : thing >> (2 * shader_.bits().normal);
      sum += things[k].count * shader_.OfObject(object, things[k], pixel);
    }
    if (ground.count > 0.0f) {
      Average(ground);
      sum += ground.count * GroundPart(ground, pixel);
    }
    for (int k = 0; k < kinds; ++k) {
      if (!things[k].of_board) continue;
      Average(things[k]);
      sum += things[k].count * shader_.BoardPart(things[k], pixel);
    }
    if (skies > 0.0f) sum += skies * shader_.Sky(pixel.middle);
    return 1.0f / count * sum;
  }

  // Neighbours mostly hit the same facet.
  Eigen::Vector3f NormalOf(std::uint32_t facet) const {
    if (facet != facet_ || !facet_known_) {
      facet_normal_ = UnpackNormal({.object = facet}, shader_.bits());
      facet_ = facet;
      facet_known_ = true;
    }
    return facet_normal_;
  }

  // From sums in the view's tan plane to means in the image's.
  void Average(Met& met) const {
    const float count = met.count, per = 1.0f / count;
    // The two kinds of cameras round differently.
    const auto mean = [&](float sum) { return kColour ? sum * per : sum / count; };
    met.inverse_depth = mean(met.inverse_depth);
    met.ray = ToImage({mean(met.ray.x), mean(met.ray.y)});
    met.from = ToImage({mean(met.from.x), mean(met.from.y)});
    if constexpr (kColour) met.normal *= per;
  }

  Value GroundPart(const Met& met, const Pixel& pixel) const {
    Value radiance{};
    shader_.Ground({.x = &met.ray.x,
                    .y = &met.ray.y,
                    .known_x = &met.from.x,
                    .known_y = &met.from.y,
                    .inverse_depth = &met.inverse_depth,
                    .along_x = &pixel.along.x,
                    .along_y = &pixel.along.y,
                    .down_x = &pixel.down.x,
                    .down_y = &pixel.down.y,
                    .count = 1,
                    .column = pixel.column,
                    .row = pixel.row},
                   &radiance);
    return radiance;
  }

  // Thin bodies before all that.
  void AddThin(const ViewSampler& view, int first, int last, Value* radiance) {
    for (std::size_t body = 0; body < view.layers().size(); ++body) {
      const ThinLayer& layer = view.layers()[body];
      if (layer.width == 0) continue;
      view.HaveThin(layer, InView(), first, last, thin_.data());
      for (int x = first; x < last; ++x) {
        if (!thin_[x]) continue;
        const Pixel pixel = row_.At(x);
        Thin sum;
        for (int k = 0; k < kRays; ++k) sum.Add(view.ThinAt(layer, ToView(pixel.Ray(k))), 0.25f);
        if (sum.cover > 0.0f) radiance[x] = shader_.OfThin(body, sum, pixel, radiance[x]);
      }
    }
  }

  ViewTurn turn_;
  PixelRow row_, turned_;
  RowRays rays_;
  std::vector<float> inverse_depth_;  // mean of a pixel's rays
  std::vector<Kind> kind_;
  std::vector<std::uint8_t> held_, thin_;  // by the close view; by bodies that are thin
  RaySource wide_;
  std::optional<RaySource> close_;
  bool has_thin_, by_facets_;
  SceneShader<Value> shader_;
  mutable Eigen::Vector3f facet_normal_{0, 0, 0};  // of the last facet that was hit
  mutable std::uint32_t facet_ = 0;
  mutable bool facet_known_ = false;
};

}  // namespace

DOCKYARD_TWO_WIDTHS
RadianceImage Compose(const PixelGrid& grid, const FlatView& wide, const FlatView* close,
                      const Lit& lit, const Pose3& X_WC, Channel channel, bool with_depth) {
  RadianceImage image{
      .width = grid.width, .height = grid.height, .values = {}, .inverse_depth = {}};
  image.values.resize(static_cast<std::size_t>(grid.width) * grid.height);
  if (with_depth) image.inverse_depth.resize(image.values.size());
  Composer<float> composer(grid.width, wide, close, kWideRays,
                           {lit, LightIn(lit.scene, channel, X_WC), X_WC, channel});
  for (int y = 0; y < grid.height; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * grid.width;
    composer.Row(grid, y, {0, grid.width}, &image.values[at]);
    if (with_depth) composer.InverseDepths(grid.width, &image.inverse_depth[at]);
  }
  return image;
}

void ComposeColour(const PixelGrid& grid, const std::vector<PixelSpan>& spans, const FlatView& wide,
                   const FlatView* close, int close_rays, const Lit& lit,
                   const ColourTable& colours, const Pose3& X_WC,
                   std::array<RadianceImage, 3>& sum) {
  Composer<Rgb> composer(grid.width, wide, close, close_rays,
                         {lit, LightBy(colours, lit.scene, X_WC), X_WC, Channel::kGrey});
  std::vector<Rgb> row(static_cast<std::size_t>(grid.width));
  for (int y = 0; y < grid.height; ++y) {
    const PixelSpan& span = spans[static_cast<std::size_t>(y)];
    composer.Row(grid, y, span, row.data());
    const std::size_t at = static_cast<std::size_t>(y) * grid.width;
    float *r = &sum[0].values[at], *g = &sum[1].values[at], *b = &sum[2].values[at];
    for (int x = span.first; x < span.last; ++x) r[x] += row[static_cast<std::size_t>(x)].r;
    for (int x = span.first; x < span.last; ++x) g[x] += row[static_cast<std::size_t>(x)].g;
    for (int x = span.first; x < span.last; ++x) b[x] += row[static_cast<std::size_t>(x)].b;
  }
}

}  // namespace dockyard
