#include "render/sun_shadow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr int kTile = 8;    // texels a side
constexpr int kSpread = 2;  // tiles round a place that its bounds cover
constexpr int kTilesWide = kAtlasWidth / kTile, kTilesHigh = kAtlasHeight / kTile;
constexpr float kMaxReach = kTile * kSpread;           // texels
constexpr float kBoundsReach = kTile * (kSpread + 1);  // texels
constexpr float kEdge = kMaxReach + 2.0f;              // texels next to the border, not looked at
constexpr float kNoCaster = -1e9f;
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
  // A margin of the texels next to the border, which are not looked up.
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
      discs_[n][i] =
          Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle)).cast<float>();
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
  ReduceTiles();
}

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
  // Over the tiles around: along the rows, then down the columns.
  const auto spread = [](const std::vector<Bounds>& from, std::vector<Bounds>& to, int step_x,
                         int step_y) {
    to.resize(from.size());
    for (int ty = 0; ty < kTilesHigh; ++ty) {
      for (int tx = 0; tx < kTilesWide; ++tx) {
        Bounds bounds = from[std::size_t{kTilesWide} * ty + tx];
        for (int k = -kSpread; k <= kSpread; ++k) {
          const int x = std::clamp(tx + k * step_x, 0, kTilesWide - 1);
          const int y = std::clamp(ty + k * step_y, 0, kTilesHigh - 1);
          const Bounds& other = from[std::size_t{kTilesWide} * y + x];
          bounds.highest = std::max(bounds.highest, other.highest);
          bounds.lowest = std::min(bounds.lowest, other.lowest);
        }
        to[std::size_t{kTilesWide} * ty + tx] = bounds;
      }
    }
  };
  spread(tiles_, around_, 1, 0);
  spread(around_, tiles_, 0, 1);
}

float SunShadow::Caster(int column, int row) const {
  const float z = depth_[static_cast<std::size_t>(row) * kAtlasWidth + column];
  return z < 1.0f ? top_ - z * range_ : kNoCaster;
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

float SunShadow::Penumbra(const Spot& spot, const Place& place, float reach, int searches,
                          int points) const {
  const Window& window = *spot.window;
  const Eigen::Vector2f& turn = turns_[Turn(place.pixel_x, place.pixel_y)];
  const float c = turn.x(), sn = turn.y();
  // How far the texel there stands over the receiver's plane.
  const auto gap = [&](const Eigen::Vector2f& point, float radius) {
    const int column = static_cast<int>(spot.x + radius * (c * point.x() - sn * point.y()));
    const int row = static_cast<int>(spot.y + radius * (sn * point.x() + c * point.y()));
    const float dx = (static_cast<float>(column) + 0.5f - spot.x) * window.texel_m;
    const float dy = (static_cast<float>(row) + 0.5f - spot.y) * window.texel_m;
    return Caster(column, row) - (place.p.z() + place.slopes.x * dx + place.slopes.y * dy);
  };
  // How far the nearest casters are decides how wide the penumbra is.
  float total = 0.0f;
  int found = 0;
  for (int i = 0; i < searches; ++i) {
    const float over = gap(discs_[searches][i], reach);
    if (over > place.bias_m) {
      total += over;
      ++found;
    }
  }
  if (found == 0) return 1.0f;
  if (found == searches) return 0.0f;
  const float penumbra = sun_radius_ * total / static_cast<float>(found);
  const float radius =
      std::clamp(std::sqrt(penumbra * penumbra + place.blur_m * place.blur_m) * window.per_texel,
                 0.8f, kMaxReach);
  int blocked = 0;
  for (int i = 0; i < points; ++i) blocked += gap(discs_[points][i], radius) > place.bias_m;
  return 1.0f - static_cast<float>(blocked) / static_cast<float>(points);
}

}  // namespace dockyard
