#include "render/sun_shadow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/base/two_widths.h"

namespace dockyard {
namespace {

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
ShadowWindow CoarseWindow(const Box& casters, const Box& scene, int texels) {
  const Eigen::Vector2d low = casters.low.cwiseMax(scene.low);
  const Eigen::Vector2d high = casters.high.cwiseMin(scene.high);
  ShadowWindow window;
  window.texels = texels;
  if ((low.array() >= high.array()).any()) return window;
  window.center_m = 0.5 * (low + high);
  // A margin of the texels next to the border, which are not used.
  window.half_m = std::clamp(0.52 * (high - low).maxCoeff(), 1.0, kWidestHalf_m);
  return window;
}

}  // namespace

ShadowFit FitShadow(const std::vector<Ball>& casters_W, const Ball& interest_W, const Pose3& X_WR,
                    const Eigen::Vector3d& to_sun_W, const ShadowDetail& detail) {
  ShadowFit fit;
  fit.X_WU = {LightAxes(to_sun_W, X_WR), interest_W.center};
  const Pose3 X_UW = Inverse(fit.X_WU);
  Box casters, scene;
  scene.Add(X_UW * interest_W.center, interest_W.radius + detail.near_m);
  scene.Add(X_UW * X_WR.p, detail.near_m);
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
  fit.coarse = CoarseWindow(casters, scene, detail.coarse_texels);
  fit.fine = {.center_m = Eigen::Vector2d::Zero(),
              .half_m = std::max(1.1 * interest_W.radius + 0.05, 0.2),
              .texels = detail.fine_texels,
              .column = detail.coarse_texels};
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
      discs_[n].x[i / 4][i % 4] = static_cast<float>(radius * std::cos(angle));
      discs_[n].y[i / 4][i % 4] = static_cast<float>(radius * std::sin(angle));
    }
  }
}

void SunShadow::Resize(const ShadowFit& fit) {
  width_ = AtlasWidth(fit.coarse.texels, fit.fine.texels);
  height_ = fit.coarse.texels;
  tiles_wide_ = width_ / kTile;
  tiles_high_ = height_ / kTile;
  plane_tiles_side_ = fit.fine.texels / kTile;
  depth_.resize(static_cast<std::size_t>(width_) * height_, 1.0f);
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
  blocks_.Clear();
  ReduceTiles();
}

void SunShadow::TakeNone(const ShadowFit& fit) {
  fit_ = fit;
  coarse_ = fine_ = {};  // no place lies in a window
  if (tiles_.empty()) tiles_.resize(1);
}

DOCKYARD_TWO_WIDTHS
void SunShadow::ReduceTiles() {
  tiles_.resize(static_cast<std::size_t>(tiles_wide_) * tiles_high_);
  nearest_.resize(static_cast<std::size_t>(width_));
  farthest_.resize(static_cast<std::size_t>(width_));
  for (int ty = 0; ty < tiles_high_; ++ty) {
    // Whole rows, as they lie in memory: tile by tile takes three times as long.
    const float* row = &depth_[std::size_t{kTile} * ty * width_];
    float* __restrict nearest = nearest_.data();
    float* __restrict farthest = farthest_.data();
    std::copy(row, row + width_, nearest);
    std::copy(row, row + width_, farthest);
    for (int y = 1; y < kTile; ++y) {
      row += width_;
      for (int x = 0; x < width_; ++x) {
        const float z = row[x];
        nearest[x] = z < nearest[x] ? z : nearest[x];
        farthest[x] = z > farthest[x] ? z : farthest[x];
      }
    }
    for (int tx = 0; tx < tiles_wide_; ++tx) {
      float low = nearest[kTile * tx], high = farthest[kTile * tx];
      for (int x = kTile * tx + 1; x < kTile * (tx + 1); ++x) {
        low = nearest[x] < low ? nearest[x] : low;
        high = farthest[x] > high ? farthest[x] : high;
      }
      tiles_[static_cast<std::size_t>(tiles_wide_) * ty + tx] = {
          .highest = low < 1.0f ? top_ - low * range_ : kNoCaster,
          .lowest = high < 1.0f ? top_ - high * range_ : kNoCaster};
    }
  }
  Spread(tiles_, 1, tiles_wide_, tiles_high_, around_, near_tiles_);
  Spread(tiles_, kSpread, tiles_wide_, tiles_high_, around_, tiles_);
}

void SunShadow::Spread(const std::vector<Bounds>& from, int tiles, int wide, int high,
                       std::vector<Bounds>& room, std::vector<Bounds>& to) {
  // Along the rows, then down the columns.
  const auto spread = [&](const std::vector<Bounds>& in, std::vector<Bounds>& out, int step_x,
                          int step_y) {
    out.resize(in.size());
    for (int ty = 0; ty < high; ++ty) {
      for (int tx = 0; tx < wide; ++tx) {
        Bounds bounds = in[static_cast<std::size_t>(ty) * wide + tx];
        for (int k = -tiles; k <= tiles; ++k) {
          const int x = std::clamp(tx + k * step_x, 0, wide - 1);
          const int y = std::clamp(ty + k * step_y, 0, high - 1);
          const Bounds& other = in[static_cast<std::size_t>(y) * wide + x];
          bounds.highest = std::max(bounds.highest, other.highest);
          bounds.lowest = std::min(bounds.lowest, other.lowest);
        }
        out[static_cast<std::size_t>(ty) * wide + tx] = bounds;
      }
    }
  };
  spread(from, room, 1, 0);
  spread(room, to, 0, 1);
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
  plane_tiles_.assign(static_cast<std::size_t>(plane_tiles_side_) * plane_tiles_side_,
                      {.highest = kNoCaster, .lowest = -kNoCaster});
  for (int row = 0; row < plane_tiles_side_ * kTile; ++row) {
    const float* depth = &depth_[static_cast<std::size_t>(row) * width_ + fine_.column];
    const float dy = (static_cast<float>(row) + 0.5f - fine_.middle) * fine_.texel_m + y0;
    Bounds* tiles = &plane_tiles_[static_cast<std::size_t>(plane_tiles_side_) * (row / kTile)];
    for (int tile = 0; tile < plane_tiles_side_; ++tile) {
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
  Spread(plane_tiles_, kSpread, plane_tiles_side_, plane_tiles_side_, around_, plane_tiles_);
}

}  // namespace dockyard
