#include "render/sun_shadow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/two_widths.h"

namespace dockyard {
namespace {

constexpr int kTile = 8;    // texels a side
constexpr int kSpread = 2;  // tiles round a place that its bounds cover
constexpr int kTilesWide = kAtlasWidth / kTile, kTilesHigh = kAtlasHeight / kTile;
constexpr float kMaxReach = kTile * kSpread;           // texels
constexpr float kBoundsReach = kTile * (kSpread + 1);  // texels
constexpr float kEdge = kMaxReach + 2.0f;              // texels next to the border, not used
constexpr float kNoCaster = -1e9f;
constexpr int kPlaneTiles = kFineTexels / kTile;  // a side of the fine window
constexpr float kPlaneSlack_m = 1e-4f;            // far above what floats lose
constexpr double kNearScene_m = 4.0;   // round rover and board, what the cameras see in detail
constexpr double kWidestHalf_m = 8.0;  // 10 mm texels at worst

// Sunflower points at multiples of the golden angle fill a disc evenly (Vogel, Mathematical
// Biosciences 44, 1979).
constexpr double kGoldenAngle_rad = 2.39996323;

// x across, level; under a sun at the zenith the rover's forward axis.
Eigen::Matrix3d LightAxes(const Eigen::Vector3d& to_sun_W, const Pose3& X_WR) {
  const Eigen::Vector3d z = to_sun_W.normalized();
  Eigen::Vector3d x = Eigen::Vector3d::UnitZ().cross(z);
  if (x.norm() < 1e-3) x = X_WR.R.col(0) - X_WR.R.col(0).dot(z) * z;
  if (x.norm() < 1e-3) x = X_WR.R.col(1) - X_WR.R.col(1).dot(z) * z;
  x.normalize();
  Eigen::Matrix3d R_WU;
  R_WU << x, z.cross(x), z;
  return R_WU;
}

struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = Eigen::Vector2d::Constant(-1e9);
  void Add(const Eigen::Vector3d& p, double radius) {
    low = low.cwiseMin(p.head<2>().array().matrix() - Eigen::Vector2d::Constant(radius));
    high = high.cwiseMax(p.head<2>().array().matrix() + Eigen::Vector2d::Constant(radius));
  }
};

// Shadows lie where casters project; only those near the scene matter.
ShadowWindow CoarseWindow(const Box& casters, const Box& scene) {
  const Eigen::Vector2d low = casters.low.cwiseMax(scene.low);
  const Eigen::Vector2d high = casters.high.cwiseMin(scene.high);
  ShadowWindow window;
  window.texels = kCoarseTexels;
  if ((low.array() >= high.array()).any()) return window;
  window.center_m = 0.5 * (low + high);
  // A margin of the texels next to the border, which are not used.
  window.half_m = std::clamp(0.52 * (high - low).maxCoeff(), 1.0, kWidestHalf_m);
  return window;
}

}  // namespace

ShadowFit FitShadow(const std::vector<Ball>& casters_W, const Ball& board_W, const Pose3& X_WR,
                    const Eigen::Vector3d& to_sun_W) {
  ShadowFit fit;
  fit.X_WU = {LightAxes(to_sun_W, X_WR), board_W.center};
  const Pose3 X_UW = Inverse(fit.X_WU);
  Box casters, scene;
  scene.Add(X_UW * board_W.center, board_W.radius + kNearScene_m);
  scene.Add(X_UW * X_WR.p, kNearScene_m);
  fit.top_m = -1e9;
  fit.bottom_m = 1e9;
  for (const Ball& ball : casters_W) {
    const Eigen::Vector3d p = X_UW * ball.center;
    casters.Add(p, ball.radius);
    fit.top_m = std::max(fit.top_m, p.z() + ball.radius + 0.01);
    fit.bottom_m = std::min(fit.bottom_m, p.z() - ball.radius - 0.01);
  }
  if (casters_W.empty()) {
    fit.top_m = 1.0;
    fit.bottom_m = 0.0;
  }
  fit.coarse = CoarseWindow(casters, scene);
  fit.fine = {.center_m = Eigen::Vector2d::Zero(),
              .half_m = std::max(1.1 * board_W.radius + 0.05, 0.2),
              .texels = kFineTexels,
              .column = kCoarseTexels};
  return fit;
}

SunShadow::SunShadow() {
  for (int i = 0; i < kTurns; ++i) {
    const double angle = 2.0 * kPi * i / kTurns;
    turns_[i] = Eigen::Vector2d(std::cos(angle), std::sin(angle)).cast<float>();
  }
  for (int n = 1; n <= kMostPoints; ++n) {
    for (int i = 0; i < n; ++i) {
      const double angle = i * kGoldenAngle_rad, radius = std::sqrt((i + 0.5) / n);
      discs_[n].x[i] = static_cast<float>(radius * std::cos(angle));
      discs_[n].y[i] = static_cast<float>(radius * std::sin(angle));
    }
  }
}

void SunShadow::Take(const ShadowFit& fit, double sun_angular_diameter_rad) {
  fit_ = fit;
  top_ = static_cast<float>(fit.top_m);
  range_ = static_cast<float>(fit.top_m - fit.bottom_m);
  sun_radius_ = static_cast<float>(0.5 * sun_angular_diameter_rad);
  const auto window = [](const ShadowWindow& w) {
    return Window{.center_x = static_cast<float>(w.center_m.x()),
                  .center_y = static_cast<float>(w.center_m.y()),
                  .texel_m = static_cast<float>(w.texel_m()),
                  .per_texel = static_cast<float>(1.0 / w.texel_m()),
                  .middle = 0.5f * static_cast<float>(w.texels),
                  .last = static_cast<float>(w.texels),
                  .column = w.column};
  };
  coarse_ = window(fit.coarse);
  fine_ = window(fit.fine);
  plane_tiles_.clear();
  ReduceTiles();
}

DOCKYARD_TWO_WIDTHS
void SunShadow::ReduceTiles() {
  tiles_.assign(std::size_t{kTilesWide} * kTilesHigh, {});
  for (int ty = 0; ty < kTilesHigh; ++ty) {
    for (int tx = 0; tx < kTilesWide; ++tx) {
      const float* corner = &depth_[std::size_t{kTile} * ty * kAtlasWidth + kTile * tx];
      float nearest[kTile], farthest[kTile];  // side by side, so that they go together
      for (int x = 0; x < kTile; ++x) nearest[x] = farthest[x] = corner[x];
      for (int y = 1; y < kTile; ++y) {
        for (int x = 0; x < kTile; ++x) {
          const float z = corner[y * kAtlasWidth + x];
          nearest[x] = z < nearest[x] ? z : nearest[x];
          farthest[x] = z > farthest[x] ? z : farthest[x];
        }
      }
      const float low = *std::min_element(nearest, nearest + kTile);
      const float high = *std::max_element(farthest, farthest + kTile);
      tiles_[std::size_t{kTilesWide} * ty + tx] = {
          .highest = low < 1.0f ? top_ - low * range_ : kNoCaster,
          .lowest = high < 1.0f ? top_ - high * range_ : kNoCaster};
    }
  }
  Spread(tiles_, around_, kTilesWide, kTilesHigh);
}

void SunShadow::Spread(std::vector<Bounds>& tiles, std::vector<Bounds>& room, int wide, int high) {
  // Along the rows, then down the columns.
  const auto spread = [&](const std::vector<Bounds>& from, std::vector<Bounds>& to, int step_x,
                          int step_y) {
    to.resize(from.size());
    for (int ty = 0; ty < high; ++ty) {
      for (int tx = 0; tx < wide; ++tx) {
        Bounds bounds = from[static_cast<std::size_t>(ty) * wide + tx];
        for (int k = -kSpread; k <= kSpread; ++k) {
          const int x = std::clamp(tx + k * step_x, 0, wide - 1);
          const int y = std::clamp(ty + k * step_y, 0, high - 1);
          const Bounds& other = from[static_cast<std::size_t>(y) * wide + x];
          bounds.highest = std::max(bounds.highest, other.highest);
          bounds.lowest = std::min(bounds.lowest, other.lowest);
        }
        to[static_cast<std::size_t>(ty) * wide + tx] = bounds;
      }
    }
  };
  spread(tiles, room, 1, 0);
  spread(room, tiles, 0, 1);
}

DOCKYARD_TWO_WIDTHS
void SunShadow::TakePlane(const Eigen::Vector3d& p_U, const Eigen::Vector3d& normal_U) {
  plane_tiles_.clear();
  // One that the sun grazes is taken as less steep than it is, about each place anew.
  if (std::abs(normal_U.z()) <= kLeastCosine) return;
  const auto slope_x = static_cast<float>(-normal_U.x() / normal_U.z());
  const auto slope_y = static_cast<float>(-normal_U.y() / normal_U.z());
  const auto x0 = fine_.center_x - static_cast<float>(p_U.x());
  const auto y0 = fine_.center_y - static_cast<float>(p_U.y());
  const auto z0 = static_cast<float>(p_U.z());
  plane_tiles_.assign(std::size_t{kPlaneTiles} * kPlaneTiles,
                      {.highest = kNoCaster, .lowest = -kNoCaster});
  for (int row = 0; row < kFineTexels; ++row) {
    const float* depth = &depth_[static_cast<std::size_t>(row) * kAtlasWidth + fine_.column];
    const float dy = (static_cast<float>(row) + 0.5f - fine_.middle) * fine_.texel_m + y0;
    Bounds* tiles = &plane_tiles_[std::size_t{kPlaneTiles} * (row / kTile)];
    for (int tile = 0; tile < kPlaneTiles; ++tile) {
      float over[kTile];
      for (int i = 0; i < kTile; ++i) {
        const int column = tile * kTile + i;
        const float dx = (static_cast<float>(column) + 0.5f - fine_.middle) * fine_.texel_m + x0;
        const float z = depth[column];
        const float caster = z < 1.0f ? top_ - z * range_ : kNoCaster;
        over[i] = caster - (z0 + slope_x * dx + slope_y * dy);
      }
      for (const float gap : over) {
        tiles[tile].highest = std::max(tiles[tile].highest, gap);
        tiles[tile].lowest = std::min(tiles[tile].lowest, gap);
      }
    }
  }
  Spread(plane_tiles_, around_, kPlaneTiles, kPlaneTiles);
}

SunShadow::Spot SunShadow::SpotOf(const Place& place) const {
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

const SunShadow::Bounds& SunShadow::BoundsAt(const Spot& spot) const {
  return tiles_[std::size_t{kTilesWide} * (static_cast<int>(spot.y) / kTile) +
                static_cast<std::size_t>(static_cast<int>(spot.x) / kTile)];
}

float SunShadow::Plain(const Place& place) const {
  const Spot spot = SpotOf(place);
  if (!spot.window) return 1.0f;
  const Bounds& bounds = BoundsAt(spot);
  if (bounds.highest < place.p.z() - spot.sway) return 1.0f;
  if (bounds.lowest > place.p.z() + spot.sway + place.bias_m) return 0.0f;
  if (!place.in_plane || plane_tiles_.empty() || spot.window != &fine_) return -1.0f;
  const int column = (static_cast<int>(spot.x) - fine_.column) / kTile;
  const Bounds& over = plane_tiles_[std::size_t{kPlaneTiles} * (static_cast<int>(spot.y) / kTile) +
                                    static_cast<std::size_t>(column)];
  if (over.highest < place.bias_m - kPlaneSlack_m) return 1.0f;
  if (over.lowest > place.bias_m + kPlaneSlack_m) return 0.0f;
  return -1.0f;
}

float SunShadow::Partly(const Place& place, int searches, int points) const {
  const Spot spot = SpotOf(place);
  if (!spot.window) return 1.0f;
  const Window& window = *spot.window;
  const float over = BoundsAt(spot).highest - place.p.z() + spot.sway;
  const float reach =
      std::clamp(std::max(sun_radius_ * over, place.blur_m) * window.per_texel, 1.5f, kMaxReach);
  if (place.length.isZero(0.0f)) return Penumbra(spot, place, reach, searches, points);
  constexpr int kParts = 4;  // of the footprint's length
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
    sum += Penumbra(part, there, reach, searches, std::max(points / 2, 1));
  }
  return sum * (1.0f / kParts);
}

// Interleaved gradient noise (Jimenez, SIGGRAPH 2014).
int SunShadow::Turn(int pixel_x, int pixel_y) {
  const float a =
      0.06711056f * static_cast<float>(pixel_x) + 0.00583715f * static_cast<float>(pixel_y);
  const float b = 52.9829189f * (a - static_cast<float>(static_cast<int>(a)));
  const float c = b - static_cast<float>(static_cast<int>(b));
  return std::min(static_cast<int>(c * kTurns), kTurns - 1);
}

DOCKYARD_TWO_WIDTHS
void SunShadow::Gaps(const Spot& spot, const Place& place, int points, float radius,
                     float* __restrict gaps) const {
  static_assert(kMostPoints % 4 == 0);
  const Window& window = *spot.window;
  const Disc& disc = discs_[points];
  const Eigen::Vector2f& turn = turns_[Turn(place.pixel_x, place.pixel_y)];
  const float c = turn.x(), sn = turn.y();
  const float x = spot.x, y = spot.y, texel_m = window.texel_m, top = top_, range = range_;
  const float p_z = place.p.z(), slope_x = place.slopes.x, slope_y = place.slopes.y;
  const int count = (points + 3) / 4 * 4;  // the surplus is not used
  int texels[kMostPoints];
  float over[kMostPoints];
  for (int i = 0; i < count; ++i) {
    const int column = static_cast<int>(x + radius * (c * disc.x[i] - sn * disc.y[i]));
    const int row = static_cast<int>(y + radius * (sn * disc.x[i] + c * disc.y[i]));
    const auto in_row = static_cast<float>(column), rows = static_cast<float>(row);
    // Exact: the map has fewer than 2^24 texels.
    texels[i] = static_cast<int>(rows * static_cast<float>(kAtlasWidth) + in_row);
    const float dx = (in_row + 0.5f - x) * texel_m, dy = (rows + 0.5f - y) * texel_m;
    over[i] = p_z + slope_x * dx + slope_y * dy;
  }
  for (int i = 0; i < count; ++i) gaps[i] = depth_[static_cast<std::size_t>(texels[i])];
  for (int i = 0; i < count; ++i) {
    const float caster = gaps[i] < 1.0f ? top - gaps[i] * range : kNoCaster;
    gaps[i] = caster - over[i];
  }
}

float SunShadow::Penumbra(const Spot& spot, const Place& place, float reach, int searches,
                          int points) const {
  float gaps[kMostPoints];
  // How far the nearest casters are decides how wide the penumbra is.
  Gaps(spot, place, searches, reach, gaps);
  float total = 0.0f;
  int found = 0;
  for (int i = 0; i < searches; ++i) {
    if (gaps[i] > place.bias_m) {
      total += gaps[i];
      ++found;
    }
  }
  if (found == 0) return 1.0f;
  if (found == searches) return 0.0f;
  const float penumbra = sun_radius_ * total / static_cast<float>(found);
  const float radius = std::clamp(
      std::sqrt(penumbra * penumbra + place.blur_m * place.blur_m) * spot.window->per_texel, 0.8f,
      kMaxReach);
  Gaps(spot, place, points, radius, gaps);
  int blocked = 0;
  for (int i = 0; i < points; ++i) blocked += gaps[i] > place.bias_m;
  return 1.0f - static_cast<float>(blocked) / static_cast<float>(points);
}

}  // namespace dockyard
