// The share of the sun's disc in sight of places, from the map that was taken last.
#include <algorithm>
#include <cmath>

#include "controller/base/two_widths.h"
#include "render/sun_shadow.h"

namespace dockyard {
namespace {

constexpr float kSlack_m = 1e-4f;                   // far above what floats lose
constexpr int kParts = 4;                           // of a footprint's length
constexpr float kOutermost = 0.5f - 0.5f / kParts;  // of their middles

}  // namespace

[[gnu::always_inline]] inline SunShadow::Spot SunShadow::SpotOf(const Place& place) const {
  const Eigen::Vector3f& p = place.p;
  Spot spot;
  const auto inside = [&](const Window& window) {
    spot.x = (p.x() - window.center_x) * window.per_texel + window.middle;
    spot.y = (p.y() - window.center_y) * window.per_texel + window.middle;
    return spot.x >= kEdge && spot.y >= kEdge && spot.x <= window.last - kEdge &&
           spot.y <= window.last - kEdge;
  };
  spot.window = inside(fine_) ? &fine_ : inside(coarse_) ? &coarse_ : nullptr;
  if (!spot.window) return spot;
  spot.x += static_cast<float>(spot.window->column);
  spot.sway =
      (std::abs(place.slopes.x) + std::abs(place.slopes.y)) * spot.window->texel_m * kBoundsReach;
  return spot;
}

std::size_t SunShadow::TileAt(const Spot& spot) const {
  return static_cast<std::size_t>(tiles_wide_) * (static_cast<int>(spot.y) / kTile) +
         static_cast<std::size_t>(static_cast<int>(spot.x) / kTile);
}

float SunShadow::Plain(const Place& place) const {
  const Spot spot = SpotOf(place);
  if (!spot.window) return 1.0f;
  const Bounds& bounds = tiles_[TileAt(spot)];
  if (bounds.highest < place.p.z() - spot.sway) return 1.0f;
  if (bounds.lowest > place.p.z() + spot.sway + place.bias_m) return 0.0f;
  if (!place.in_plane || plane_tiles_.empty() || spot.window != &fine_) return -1.0f;
  const int column = (static_cast<int>(spot.x) - fine_.column) / kTile;
  const Bounds& over = plane_tiles_[static_cast<std::size_t>(plane_tiles_side_) *
                                        (static_cast<int>(spot.y) / kTile) +
                                    static_cast<std::size_t>(column)];
  if (over.highest < place.bias_m - kSlack_m) return 1.0f;
  if (over.lowest > place.bias_m + kSlack_m) return 0.0f;
  return -1.0f;
}

// The points of a disc lie inside of it, so that none is beyond the block's margin.
[[gnu::always_inline]] inline float SunShadow::PlainInBlock(float x, float y, float z_m,
                                                            const ShadowBlocks::Rises& rises,
                                                            float bias_m, float reach) const {
  if (!blocks_.Repeats(rises) || reach > static_cast<float>(ShadowBlocks::kMargin)) return -1.0f;
  const int column = static_cast<int>(x) & -ShadowBlocks::kSide;
  const int row = static_cast<int>(y) & -ShadowBlocks::kSide;
  const ShadowBlocks::Bounds bounds =
      blocks_.Over({depth_.data(), width_, top_, range_}, column, row, rises);
  const float corner =
      z_m - rises.x * (x - static_cast<float>(column)) - rises.y * (y - static_cast<float>(row));
  if (bounds.highest < corner + bias_m - kSlack_m) return 1.0f;
  if (bounds.lowest > corner + bias_m + kSlack_m) return 0.0f;
  return -1.0f;
}

// Loops of few arrays without branches, which the compiler takes many at a time.
DOCKYARD_TWO_WIDTHS
void SunShadow::PlainOf(const Places& at, int count, float bias_m, bool in_plane,
                        float* __restrict shares) const {
  constexpr int kAtOnce = 64;
  const Window fine = fine_, coarse = coarse_;
  const auto fine_column = static_cast<float>(fine.column);
  const auto coarse_column = static_cast<float>(coarse.column);
  const float fine_end = fine.last - kEdge, coarse_end = coarse.last - kEdge;
  const int tiles_wide = tiles_wide_, plane_tiles = plane_tiles_side_;
  const bool by_plane = in_plane && !plane_tiles_.empty();
  for (int first = 0; first < count; first += kAtOnce) {
    const int n = std::min(kAtOnce, count - first);
    const float *p_x = at.p_x + first, *p_y = at.p_y + first, *p_z = at.p_z + first;
    const float *slope_x = at.slope_x + first, *slope_y = at.slope_y + first;
    std::int32_t tile[kAtOnce], plane_tile[kAtOnce];
    float sway[kAtOnce], highest[kAtOnce], lowest[kAtOnce];
    float spot_x[kAtOnce], spot_y[kAtOnce], texel_m[kAtOnce], per_texel[kAtOnce];
    std::int32_t in_fine[kAtOnce], in_any[kAtOnce];
    for (int i = 0; i < n; ++i) {
      const float fx = (p_x[i] - fine.center_x) * fine.per_texel + fine.middle;
      const float fy = (p_y[i] - fine.center_y) * fine.per_texel + fine.middle;
      const float cx = (p_x[i] - coarse.center_x) * coarse.per_texel + coarse.middle;
      const float cy = (p_y[i] - coarse.center_y) * coarse.per_texel + coarse.middle;
      const bool is_fine = (fx >= kEdge) & (fy >= kEdge) & (fx <= fine_end) & (fy <= fine_end);
      const bool is_coarse =
          (cx >= kEdge) & (cy >= kEdge) & (cx <= coarse_end) & (cy <= coarse_end);
      const float x = is_fine ? fx + fine_column : is_coarse ? cx + coarse_column : 0.0f;
      const float y = is_fine ? fy : is_coarse ? cy : 0.0f;
      const std::int32_t column = static_cast<std::int32_t>(x) >> 3;
      const std::int32_t row = static_cast<std::int32_t>(y) >> 3;
      tile[i] = row * tiles_wide + column;
      plane_tile[i] = is_fine ? row * plane_tiles + column - fine.column / kTile : 0;
      in_fine[i] = is_fine;
      in_any[i] = is_fine | is_coarse;
      spot_x[i] = x;
      spot_y[i] = y;
      texel_m[i] = is_fine ? fine.texel_m : coarse.texel_m;
      per_texel[i] = is_fine ? fine.per_texel : coarse.per_texel;
      sway[i] = (std::abs(slope_x[i]) + std::abs(slope_y[i])) * texel_m[i] * kBoundsReach;
    }
    for (int i = 0; i < n; ++i) {
      highest[i] = tiles_[static_cast<std::size_t>(tile[i])].highest;
      lowest[i] = tiles_[static_cast<std::size_t>(tile[i])].lowest;
    }
    float* share = shares + first;
    for (int i = 0; i < n; ++i) {
      const bool lit = (in_any[i] == 0) | (highest[i] < p_z[i] - sway[i]);
      const bool dark = lowest[i] > p_z[i] + sway[i] + bias_m;
      share[i] = lit ? 1.0f : dark ? 0.0f : -1.0f;
    }
    for (int i = 0; by_plane && i < n; ++i) {
      const Bounds& over = plane_tiles_[static_cast<std::size_t>(plane_tile[i])];
      const bool open = (share[i] < 0.0f) & (in_fine[i] != 0);
      const bool lit = open & (over.highest < bias_m - kSlack_m);
      const bool dark = open & (over.lowest > bias_m + kSlack_m);
      share[i] = lit ? 1.0f : dark ? 0.0f : share[i];
    }
    if (at.blur_m == nullptr) continue;
    const float* blur_m = at.blur_m + first;
    float reach[kAtOnce], rise_x[kAtOnce], rise_y[kAtOnce];
    const float sun_radius = sun_radius_;
    for (int i = 0; i < n; ++i) {
      const float penumbra_m = sun_radius * (highest[i] - p_z[i] + sway[i]);
      reach[i] = (penumbra_m < blur_m[i] ? blur_m[i] : penumbra_m) * per_texel[i];
      rise_x[i] = slope_x[i] * texel_m[i];
      rise_y[i] = slope_y[i] * texel_m[i];
    }
    for (int i = 0; i < n; ++i) {
      if (share[i] >= 0.0f) continue;
      share[i] =
          PlainInBlock(spot_x[i], spot_y[i], p_z[i], {rise_x[i], rise_y[i]}, bias_m, reach[i]);
    }
  }
}

// Interleaved gradient noise (Jimenez, SIGGRAPH 2014).
int SunShadow::Turn(int pixel_x, int pixel_y) {
  const float a =
      0.06711056f * static_cast<float>(pixel_x) + 0.00583715f * static_cast<float>(pixel_y);
  const float b = 52.9829189f * (a - static_cast<float>(static_cast<int>(a)));
  const float c = b - static_cast<float>(static_cast<int>(b));
  return std::min(static_cast<int>(c * kTurns), kTurns - 1);
}

[[gnu::always_inline]] inline void SunShadow::FindGaps(const Spot& spot, const Place& place,
                                                       const Eigen::Vector2f& turn, int points,
                                                       float radius, Gaps& gaps) const {
  const Disc& disc = discs_[points];
  const float c = turn.x(), sn = turn.y();
  const float texel_m = spot.window->texel_m;
  const int fours = (points + 3) / 4;
  for (int i = 0; i < fours; ++i) {
    const FourInts column = Truncated(spot.x + radius * (c * disc.x[i] - sn * disc.y[i]));
    const FourInts row = Truncated(spot.y + radius * (sn * disc.x[i] + c * disc.y[i]));
    const Four in_row = ToFloats(column), rows = ToFloats(row);
    // Exact: the map has fewer than 2^24 texels.
    const FourInts at = Truncated(rows * static_cast<float>(width_) + in_row);
    const float* map = depth_.data();
    const Four depth{map[at[0]], map[at[1]], map[at[2]], map[at[3]]};
    const Four dx = (in_row + 0.5f - spot.x) * texel_m, dy = (rows + 0.5f - spot.y) * texel_m;
    const Four over = place.p.z() + place.slopes.x * dx + place.slopes.y * dy;
    const Four none = {kNoCaster, kNoCaster, kNoCaster, kNoCaster};
    gaps[i] = (depth < 1.0f ? top_ - depth * range_ : none) - over;
  }
  for (int i = points; i < 4 * fours; ++i) gaps[i / 4][i % 4] = kNoCaster;
}

[[gnu::always_inline]] inline float SunShadow::Penumbra(const Spot& spot, const Place& place,
                                                        const Eigen::Vector2f& turn, float reach,
                                                        int searches, int points) const {
  const float texel_m = spot.window->texel_m;
  const float plain =
      PlainInBlock(spot.x, spot.y, place.p.z(),
                   {place.slopes.x * texel_m, place.slopes.y * texel_m}, place.bias_m, reach);
  if (plain >= 0.0f) return plain;
  Gaps gaps{};
  const float bias = place.bias_m;
  const auto standing = [&](int count) {
    FourInts sum = gaps[0] > bias;  // -1 each
    for (int i = 1; i < (count + 3) / 4; ++i) sum += gaps[i] > bias;
    return -(sum[0] + sum[1] + sum[2] + sum[3]);
  };
  // How far the nearest casters are decides how wide the penumbra is.
  FindGaps(spot, place, turn, searches, reach, gaps);
  const int found = standing(searches);
  if (found == 0) return 1.0f;
  if (found == searches) return 0.0f;
  float total = 0.0f;  // in the points' order, without a branch, which no processor could foresee
  const int fours = (searches + 3) / 4;
  for (int i = 0; i < fours; ++i) {
    const Four kept = gaps[i] > bias ? gaps[i] : Four{};
    total = (((total + kept[0]) + kept[1]) + kept[2]) + kept[3];
  }
  const float penumbra = sun_radius_ * total / static_cast<float>(found);
  const float radius = std::clamp(
      std::sqrt(penumbra * penumbra + place.blur_m * place.blur_m) * spot.window->per_texel, 0.8f,
      kMaxReach);
  FindGaps(spot, place, turn, points, radius, gaps);
  return 1.0f - static_cast<float>(standing(points)) / static_cast<float>(points);
}

[[gnu::always_inline]] inline float SunShadow::PlainNear(const Spot& spot, const Place& place,
                                                         float reach) const {
  const float half_x = kOutermost * std::abs(place.length.x());
  const float half_y = kOutermost * std::abs(place.length.y());
  if (reach + std::max(half_x, half_y) * spot.window->per_texel > kTile) return -1.0f;
  const Bounds& bounds = near_tiles_[TileAt(spot)];
  const float sway =
      (std::abs(place.slopes.x) + std::abs(place.slopes.y)) * spot.window->texel_m * (kTile + 1) +
      kOutermost * std::abs(place.length.z()) + kSlack_m;
  if (bounds.highest < place.p.z() - sway + place.bias_m) return 1.0f;
  if (bounds.lowest > place.p.z() + sway + place.bias_m) return 0.0f;
  return -1.0f;
}

DOCKYARD_TWO_WIDTHS
float SunShadow::Partly(const Place& place, int searches, int points) const {
  const Spot spot = SpotOf(place);
  if (!spot.window) return 1.0f;
  const Window& window = *spot.window;
  const Eigen::Vector2f& turn = turns_[Turn(place.pixel_x, place.pixel_y)];
  const float over = tiles_[TileAt(spot)].highest - place.p.z() + spot.sway;
  const float reach =
      std::clamp(std::max(sun_radius_ * over, place.blur_m) * window.per_texel, 1.5f, kMaxReach);
  const float plain = PlainNear(spot, place, reach);
  if (plain >= 0.0f) return plain;
  if (place.length.isZero(0.0f)) return Penumbra(spot, place, turn, reach, searches, points);
  const float first = static_cast<float>(window.column) + kEdge;
  const float last = static_cast<float>(window.column) + window.last - kEdge;
  float sum = 0.0f;
  for (int i = 0; i < kParts; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / kParts - 0.5f;
    Spot part = spot;
    part.x = std::clamp(spot.x + u * place.length.x() * window.per_texel, first, last);
    part.y =
        std::clamp(spot.y + u * place.length.y() * window.per_texel, kEdge, window.last - kEdge);
    Place there = place;
    there.p += u * place.length;
    sum += Penumbra(part, there, turn, reach, searches, std::max(points / 2, 1));
  }
  return sum * (1.0f / kParts);
}

}  // namespace dockyard
