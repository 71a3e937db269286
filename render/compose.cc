#include "render/compose.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "render/board_ink.h"
#include "render/ground_mesh.h"
#include "render/ground_shader.h"
#include "render/object_shader.h"
#include "render/sky_shader.h"
#include "render/two_widths.h"
#include "render/view_sampler.h"

namespace dockyard {
namespace {

// The kind of surface that all rays of a pixel met.
enum class Kind : std::uint8_t { kOther, kGround, kSky, kBoard };

// Rays of one pixel that met one thing.
struct Met {
  float count = 0.0f, code = 0.0f;
  Tan ray, from;  // where the pixel's rays point; where those of the view that met it point

  void Add(float c, Tan r, Tan f) {
    ++count;
    code += c;
    ray = {ray.x + r.x, ray.y + r.y};
    from = {from.x + f.x, from.y + f.y};
  }
  float MeanCode() const { return code / count; }
  Tan MeanRay() const { return {ray.x / count, ray.y / count}; }
  Tan MeanFrom() const { return {from.x / count, from.y / count}; }
};

// One camera's image, row by row.
class Composer {
 public:
  Composer(int width, const FlatView& wide, const FlatView* close, const Lit& lit,
           const Pose3& X_WC, Channel channel)
      : row_(width),
        rays_(width),
        code_(width),
        kind_(width),
        held_(width, 0),
        thin_(width, 0),
        wide_(wide),
        has_thin_(wide.HasThin() || (close && close->HasThin())),
        sky_(lit.scene, X_WC, channel),
        objects_(lit.scene, lit.ground.highest_m(), lit.shadow, X_WC, channel) {
    if (close) close_.emplace(*close);
    if (HasGround(lit.scene.ground)) {
      ground_.emplace(lit.ground, lit.scene, lit.shadow, X_WC, channel);
    }
    if (lit.scene.board.board.width_m > 0.0) board_.emplace(lit.scene, X_WC, channel);
  }

  void Row(const PixelGrid& grid, int y, float* radiance) {
    row_.Fill(grid, y);
    if (close_) close_->Hold(row_, grid.width, held_.data());
    for (int first = 0, last; first < grid.width; first = last) {
      last = first + 1;
      while (last < grid.width && held_[last] == held_[first]) ++last;
      Part(held_[first] ? *close_ : wide_, first, last, radiance);
    }
  }
  /// 1/z of the surface in the middle of a pixel of the last row, thin bodies aside.
  float InverseDepthAt(int x) const { return InverseDepth(wide_.At(Middle(x)).code); }

 private:
  Tan Middle(int x) const { return {row_.x[x], row_.y[x]}; }

  // Pixels first to last - 1, all from one view.
  void Part(const ViewSampler& view, int first, int last, float* radiance) {
    view.Find(row_, first, last, rays_);
    for (int x = first; x < last; ++x) {
      constexpr int kAhead = 24;
      if (x + kAhead < last) {
        view.Prefetch(rays_.at[1][x + kAhead]);
        view.Prefetch(rays_.at[3][x + kAhead]);
      }
      const float a = view.At(rays_.at[0][x]).code, b = view.At(rays_.at[1][x]).code;
      const float c = view.At(rays_.at[2][x]).code, d = view.At(rays_.at[3][x]).code;
      const float least = std::min(std::min(a, b), std::min(c, d));
      const float most = std::max(std::max(a, b), std::max(c, d));
      code_[x] = 0.25f * (a + b + c + d);
      kind_[x] = least > 0.0f && most < kBoardCode ? Kind::kGround
                 : least == 0.0f && most == 0.0f   ? Kind::kSky
                 : least >= kBoardCode             ? Kind::kBoard
                                                   : Kind::kOther;
    }
    for (int from = first, to; from < last; from = to) {
      to = from + 1;
      while (to < last && kind_[to] == kind_[from]) ++to;
      if (kind_[from] == Kind::kGround) {
        Ground(from, to, radiance);
      } else if (kind_[from] == Kind::kSky) {
        sky_(&row_.x[from], &row_.y[from], to - from, radiance + from);
      } else if (kind_[from] == Kind::kBoard) {
        Board(from, to, radiance);
      } else {
        for (int x = from; x < to; ++x) radiance[x] = Mixed(view, x);
      }
    }
    if (!has_thin_) return;
    for (std::size_t body = 0; body < view.layers().size(); ++body) {
      if (view.layers()[body].width == 0) continue;
      view.HaveThin(view.layers()[body], row_, first, last, thin_.data());
      for (int x = first; x < last; ++x) {
        if (thin_[x]) radiance[x] = Behind(view, body, x, radiance[x]);
      }
    }
  }

  void Ground(int from, int to, float* radiance) const {
    (*ground_)({.x = &row_.x[from],
                .y = &row_.y[from],
                .known_x = &rays_.from_x[from],
                .known_y = &rays_.from_y[from],
                .inverse_depth = &code_[from],
                .along_x = &row_.along_x[from],
                .along_y = &row_.along_y[from],
                .down_x = &row_.down_x[from],
                .down_y = &row_.down_y[from],
                .count = to - from,
                .column = from,
                .row = row_.number},
               radiance + from);
  }

  // Pixels of which all rays met the board.
  void Board(int from, int to, float* radiance) {
    for (int x = from; x < to; x += kBoardAtOnce) {
      const int count = std::min(kBoardAtOnce, to - x);
      float shares[kBoardAtOnce];
      objects_.BoardShares(row_, x, count, shares);
      board_->Row(row_, x, count, shares, radiance + x);
    }
  }

  // Rays of one pixel that met objects, the board, or different things.
  float Mixed(const ViewSampler& view, int x) const {
    const Pixel pixel = row_.At(x);
    Seen seen[kRays];
    Tan from[kRays];  // of the view's rays: each up to half a ray's distance off the pixel's own
    for (int k = 0; k < kRays; ++k) {
      seen[k] = view.At(rays_.at[k][x]);
      from[k] = view.From(rays_, k, x);
    }
    float radiance = 0.0f, skies = 0.0f;
    Met grounds, boards;
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
    if (grounds.count > 0.0f) radiance += grounds.count * GroundPart(pixel, grounds, x);
    if (boards.count > 0.0f) {
      const float share = objects_.BoardShare(boards.MeanRay(), pixel);
      radiance += boards.count * (*board_)(pixel.corners(), share);
    }
    if (skies > 0.0f) radiance += skies * sky_(pixel.middle);
    return radiance * (1.0f / kRays);
  }

  float GroundPart(const Pixel& pixel, const Met& met, int x) const {
    const Tan ray = met.MeanRay(), from = met.MeanFrom();
    const float code = met.MeanCode();
    float radiance = 0.0f;
    (*ground_)({.x = &ray.x,
                .y = &ray.y,
                .known_x = &from.x,
                .known_y = &from.y,
                .inverse_depth = &code,
                .along_x = &pixel.along.x,
                .along_y = &pixel.along.y,
                .down_x = &pixel.down.x,
                .down_y = &pixel.down.y,
                .count = 1,
                .column = x,
                .row = row_.number},
               &radiance);
    return radiance;
  }

  // All rays that met the facet of ray k are shaded once, in their middle, by the first of them.
  float Facet(const Pixel& pixel, const Seen (&seen)[kRays], const Tan (&from)[kRays],
              int k) const {
    Met met;
    for (int j = 0; j < kRays; ++j) {
      if (!IsObject(seen[j].code) || seen[j].object != seen[k].object) continue;
      if (j < k) return 0.0f;
      met.Add(seen[j].code, pixel.Ray(j), from[j]);
    }
    const Seen middle{.object = seen[k].object, .code = met.MeanCode()};
    return met.count * objects_(middle, met.MeanFrom(), met.MeanRay(), pixel);
  }

  // The same behind a thin body.
  float Behind(const ViewSampler& view, std::size_t body, int x, float radiance) const {
    const Pixel pixel = row_.At(x);
    Thin sum;
    for (int k = 0; k < kRays; ++k) sum.Add(view.ThinAt(view.layers()[body], pixel.Ray(k)), 0.25f);
    if (sum.cover <= 0.0f) return radiance;
    return radiance * (1.0f - sum.cover) + objects_.OfThin(body, sum, pixel.middle, pixel);
  }

  PixelRow row_;
  RowRays rays_;
  std::vector<float> code_;
  std::vector<Kind> kind_;
  std::vector<std::uint8_t> held_, thin_;  // by the close view; by bodies that are thin
  ViewSampler wide_;
  std::optional<ViewSampler> close_;
  bool has_thin_;
  SkyShader sky_;
  ObjectShader objects_;
  std::optional<GroundShader> ground_;
  std::optional<BoardShader> board_;
};

}  // namespace

DOCKYARD_TWO_WIDTHS
RadianceImage Compose(const PixelGrid& grid, const FlatView& wide, const FlatView* close,
                      const Lit& lit, const Pose3& X_WC, Channel channel, bool with_depth) {
  RadianceImage image{
      .width = grid.width, .height = grid.height, .values = {}, .inverse_depth = {}};
  image.values.resize(static_cast<std::size_t>(grid.width) * grid.height);
  Composer composer(grid.width, wide, close, lit, X_WC, channel);
  for (int y = 0; y < grid.height; ++y) {
    composer.Row(grid, y, &image.values[static_cast<std::size_t>(y) * grid.width]);
    for (int x = 0; with_depth && x < grid.width; ++x) {
      image.inverse_depth.push_back(composer.InverseDepthAt(x));
    }
  }
  return image;
}

}  // namespace dockyard
