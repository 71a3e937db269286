#include "render/shadow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/shaders.h"

namespace dockyard {
namespace {

constexpr int kAtlasWidth = kCoarseTexels + kFineTexels, kAtlasHeight = kCoarseTexels;
constexpr int kTilesWide = kAtlasWidth / kShadowTile, kTilesHigh = kAtlasHeight / kShadowTile;
constexpr double kNearScene_m = 4.0;   // round rover and board, what the cameras see in detail
constexpr double kWidestHalf_m = 8.0;  // 10 mm texels at worst
constexpr int kShadowUnit = 0, kTilesUnit = 1;

GlTexture& Prepared(const GlFunctions& gl, GlTexture& texture, GLint internal, int w, int h,
                    GLenum format) {
  (void)gl;
  texture.Image(internal, w, h, format, GL_FLOAT, nullptr);
  texture.Sampling(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
  return texture;
}

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

Eigen::Matrix4d ClipFromLight(const ShadowFit& fit, const ShadowWindow& window) {
  const double range = fit.top_m - fit.bottom_m;
  Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();
  clip(0, 0) = clip(1, 1) = 1.0 / window.half_m;
  clip(0, 3) = -window.center_m.x() / window.half_m;
  clip(1, 3) = -window.center_m.y() / window.half_m;
  clip(2, 2) = -2.0 / range;
  clip(2, 3) = 2.0 * fit.top_m / range - 1.0;
  return clip;
}

Eigen::Vector4d WindowUniform(const ShadowWindow& window) {
  return {window.center_m.x(), window.center_m.y(), 1.0 / window.texel_m(),
          static_cast<double>(window.texels)};
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

ShadowMap::ShadowMap(const GlFunctions& gl)
    : gl_(gl),
      depth_(gl),
      tiles_(gl),
      spread_(gl),
      depth_target_(gl, nullptr,
                    &Prepared(gl, depth_, GL_DEPTH_COMPONENT32F, kAtlasWidth, kAtlasHeight,
                              GL_DEPTH_COMPONENT)),
      tiles_target_(gl, &Prepared(gl, tiles_, GL_RG32F, kTilesWide, kTilesHigh, GL_RG), nullptr),
      spread_target_(gl, &Prepared(gl, spread_, GL_RG32F, kTilesWide, kTilesHigh, GL_RG), nullptr),
      depth_program_(gl, DepthVertexShader(), DepthFragmentShader()),
      bounds_program_(gl, FullScreenVertexShader(), TileBoundsFragmentShader()),
      spread_program_(gl, FullScreenVertexShader(), TileSpreadFragmentShader()) {}

void ShadowMap::Render(const ShadowFit& fit, const DrawCasters& draw) {
  depth_target_.Bind(kAtlasWidth, kAtlasHeight);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LESS);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  depth_program_.Use();
  for (const ShadowWindow& window : {fit.coarse, fit.fine}) {
    gl_.Viewport(window.column, 0, window.texels, window.texels);
    draw(depth_program_, ClipFromLight(fit, window), window);
  }
  ReduceTiles(fit);
}

void ShadowMap::ReduceTiles(const ShadowFit& fit) {
  gl_.Disable(GL_DEPTH_TEST);
  tiles_target_.Bind(kTilesWide, kTilesHigh);
  bounds_program_.Use();
  depth_.Bind(kShadowUnit);
  bounds_program_.Set("u_shadow", kShadowUnit);
  bounds_program_.Set("u_depth", Eigen::Vector2d(fit.top_m, fit.top_m - fit.bottom_m));
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  spread_target_.Bind(kTilesWide, kTilesHigh);
  spread_program_.Use();
  tiles_.Bind(kTilesUnit);
  spread_program_.Set("u_tiles", kTilesUnit);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  highest_.resize(static_cast<std::size_t>(kTilesWide) * kTilesHigh);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(0, 0, kTilesWide, kTilesHigh, GL_RED, GL_FLOAT, highest_.data());
}

bool ShadowMap::MayBeShaded(const ShadowFit& fit, const Eigen::AlignedBox3d& box_U,
                            double slope) const {
  return WindowMayShade(fit.fine, box_U, slope) || WindowMayShade(fit.coarse, box_U, slope);
}

bool ShadowMap::WindowMayShade(const ShadowWindow& window, const Eigen::AlignedBox3d& box_U,
                               double slope) const {
  // As in the shader: the ground may sink away under the neighbourhood that a tile stands for.
  const double sway = slope * window.texel_m() * kShadowTile * (kShadowReachTiles + 1);
  const double floor_m = box_U.min().z() - sway - 0.01;
  const auto tile = [&](double u_m) {
    const double texel = u_m / window.texel_m() + 0.5 * window.texels;
    return static_cast<int>(std::clamp(std::floor(texel / kShadowTile), -1e6, 1e6));
  };
  const int tiles = window.texels / kShadowTile, column = window.column / kShadowTile;
  const Eigen::Vector2d low = box_U.min().head<2>() - window.center_m;
  const Eigen::Vector2d high = box_U.max().head<2>() - window.center_m;
  for (int y = std::max(tile(low.y()), 0); y <= std::min(tile(high.y()), tiles - 1); ++y) {
    for (int x = std::max(tile(low.x()), 0); x <= std::min(tile(high.x()), tiles - 1); ++x) {
      if (highest_[static_cast<std::size_t>(y) * kTilesWide + column + x] > floor_m) return true;
    }
  }
  return false;
}

void ShadowMap::Apply(const ShadowFit& fit, GlProgram& program) const {
  depth_.Bind(kShadowUnit);
  spread_.Bind(kTilesUnit);
  program.Set("u_shadow", kShadowUnit);
  program.Set("u_tiles", kTilesUnit);
  program.Set("u_coarse", WindowUniform(fit.coarse));
  program.Set("u_fine", WindowUniform(fit.fine));
  program.Set("u_fine_column", static_cast<double>(fit.fine.column));
  program.Set("u_depth", Eigen::Vector2d(fit.top_m, fit.top_m - fit.bottom_m));
}

}  // namespace dockyard
