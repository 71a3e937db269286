#include "render/object_shader.h"

#include <algorithm>
#include <cmath>

#include "controller/base/two_widths.h"

namespace dockyard {
namespace {

// A shaded facet's normal and its plane differ by the sagitta of its curve.
constexpr float kCurvedBias_m = 0.003f, kFlatBias_m = 0.001f;
// Points of the sun's disc: to find casters, to measure their cover.
constexpr int kSearches = 4, kPoints = 8, kBoardSearches = 8, kBoardPoints = 16;

}  // namespace

Eigen::Vector3f UnpackNormal(const Seen& seen, HitBits bits) {
  const float per_step = 2.0f / static_cast<float>(bits.NormalSteps());
  const std::uint32_t mask = (1u << bits.normal) - 1u;
  const float x = static_cast<float>(seen.object & mask) * per_step - 1.0f;
  const float y = static_cast<float>(seen.object >> bits.normal & mask) * per_step - 1.0f;
  const float z = 1.0f - std::abs(x) - std::abs(y);
  const float back = std::max(-z, 0.0f);  // folded over the edges
  const float nx = x >= 0.0f ? x - back : x + back, ny = y >= 0.0f ? y - back : y + back;
  const float shorten = 1.0f / std::sqrt(nx * nx + ny * ny + z * z);
  return {nx * shorten, ny * shorten, z * shorten};
}

ObjectShader::ObjectShader(const Scene& scene, double highest_m, const SunShadow& shadow,
                           const Pose3& X_WC)
    : shadow_(shadow), horizon_(scene, highest_m) {
  const Pose3 X_UC = Inverse(shadow_.fit().X_WU) * X_WC;
  R_UC_ = X_UC.R.cast<float>();
  p_UC_ = X_UC.p.cast<float>();
  const Pose3 X_GC = Inverse(scene.ground.X_WG) * X_WC;
  R_GC_ = X_GC.R.cast<float>();
  p_GC_ = X_GC.p.cast<float>();
  for (const SceneObject& object : scene.objects) stains_.emplace_back(object, X_WC);
  for (const BoardView& board : scene.boards) {
    const Eigen::Vector3d n_C = X_WC.R.transpose() * board.X_WB.R.col(2);
    const Eigen::Vector3f n_U =
        (shadow_.fit().X_WU.R.transpose() * board.X_WB.R.col(2)).cast<float>();
    const bool face = (Inverse(board.X_WB) * X_WC.p).z() < 0.0;  // which points along -z
    boards_.push_back(
        {.n_U = face ? Eigen::Vector3f(-n_U) : n_U,
         .plane_C = (n_C / n_C.dot(X_WC.R.transpose() * (board.X_WB.p - X_WC.p))).cast<float>(),
         .in_plane = boards_.empty()});
  }
}

float ObjectShader::Stain(std::size_t object, Tan tan, Tan ray, float inverse_depth,
                          const Eigen::Vector3f& n, const Pixel& pixel) const {
  if (!stains_[object].any()) return 1.0f;
  return stains_[object].At({tan, ray, inverse_depth, R_UC_.transpose() * n, pixel.blur()});
}

float ObjectShader::BoardShare(std::size_t board, Tan tan, const Pixel& pixel) const {
  const Board& b = boards_[board];
  if (b.n_U.z() <= 0.0f) return 0.0f;
  // Its plane is known better than any ray's depth.
  const float inverse_depth = b.plane_C.x() * tan.x + b.plane_C.y() * tan.y + b.plane_C.z();
  return Share(tan, inverse_depth, b.n_U, kFlatBias_m, pixel, kBoardSearches, kBoardPoints,
               b.in_plane);
}

DOCKYARD_TWO_WIDTHS
void ObjectShader::BoardShares(std::size_t board, const PixelRow& row, int first, int count,
                               float* shares) const {
  const Board& b = boards_[board];
  if (b.n_U.z() <= 0.0f) {
    std::fill(shares, shares + count, 0.0f);
    return;
  }
  Places at;
  float *x = at.x.data(), *y = at.y.data(), *z = at.z.data();
  const Eigen::Vector3f plane = b.plane_C;
  const float* __restrict mx = &row.x[first];
  const float* __restrict my = &row.y[first];
  const float* __restrict ax = &row.along_x[first];
  const float* __restrict ay = &row.along_y[first];
  const float* __restrict dx = &row.down_x[first];
  const float* __restrict dy = &row.down_y[first];
  // The middle of the pixel's four rays, added up in their order.
  const auto mean = [](float at, float along, float down) {
    const float r0 = at + -0.25f * along + -0.25f * down, r1 = at + 0.25f * along + -0.25f * down;
    const float r2 = at + -0.25f * along + 0.25f * down, r3 = at + 0.25f * along + 0.25f * down;
    return (r0 + r1 + r2 + r3) * 0.25f;
  };
  for (int i = 0; i < count; ++i) x[i] = mean(mx[i], ax[i], dx[i]);
  for (int i = 0; i < count; ++i) y[i] = mean(my[i], ay[i], dy[i]);
  for (int i = 0; i < count; ++i) {
    // Its plane is known better than any ray's depth.
    z[i] = 1.0f / (plane.x() * x[i] + plane.y() * y[i] + plane.z());
    x[i] = z[i] * x[i];
    y[i] = z[i] * y[i];
  }
  const SunShadow::Slopes slopes = SunShadow::SlopesOf(b.n_U);
  std::fill(at.slope_x.begin(), at.slope_x.begin() + count, slopes.x);
  std::fill(at.slope_y.begin(), at.slope_y.begin() + count, slopes.y);
  SharesAt(at, {kFlatBias_m, kBoardSearches, kBoardPoints, b.in_plane}, row, first, count, shares);
}

DOCKYARD_TWO_WIDTHS
void ObjectShader::FacetShares(const FacetRow& facets, const PixelRow& row, int first, int count,
                               float* shares) const {
  Places at;
  for (int i = 0; i < count; ++i) {
    const float z = 1.0f / facets.inverse_depth[i];
    at.x[i] = z * facets.from_x[i];
    at.y[i] = z * facets.from_y[i];
    at.z[i] = z;
  }
  constexpr float kLeast = SunShadow::kLeastCosine;
  for (int i = 0; i < count; ++i) {
    const float n_z = facets.n_z[i], per_z = -1.0f / (n_z > kLeast ? n_z : kLeast);
    at.slope_x[i] = facets.n_x[i] * per_z;
    at.slope_y[i] = facets.n_y[i] * per_z;
  }
  SharesAt(at, {kCurvedBias_m, kSearches, kPoints}, row, first, count, shares);
}

DOCKYARD_TWO_WIDTHS
void ObjectShader::SharesAt(const Places& at, const Fineness& fineness, const PixelRow& row,
                            int first, int count, float* shares) const {
  constexpr int kMost = kBoardAtOnce;
  float u_x[kMost], u_y[kMost], u_z[kMost], g_z[kMost], blur_m[kMost];
  const float *x = at.x.data(), *y = at.y.data(), *z = at.z.data();
  const Eigen::Vector3f p = p_UC_;
  const Eigen::Matrix3f m = R_UC_, g = R_GC_;
  const float above = p_GC_.z();
  for (int i = 0; i < count; ++i) {
    u_x[i] = p.x() + (m(0, 0) * x[i] + (m(0, 1) * y[i] + m(0, 2) * z[i]));
    u_y[i] = p.y() + (m(1, 0) * x[i] + (m(1, 1) * y[i] + m(1, 2) * z[i]));
    u_z[i] = p.z() + (m(2, 0) * x[i] + (m(2, 1) * y[i] + m(2, 2) * z[i]));
  }
  for (int i = 0; i < count; ++i) {
    g_z[i] = above + (g(2, 0) * x[i] + (g(2, 1) * y[i] + g(2, 2) * z[i]));
  }
  const float *ax = &row.along_x[first], *ay = &row.along_y[first];
  const float *dx = &row.down_x[first], *dy = &row.down_y[first];
  for (int i = 0; i < count; ++i) {  // Pixel::blur
    blur_m[i] =
        0.25f * (std::abs(ax[i]) + std::abs(ay[i]) + std::abs(dx[i]) + std::abs(dy[i])) * z[i];
  }
  shadow_.PlainOf({u_x, u_y, u_z, at.slope_x.data(), at.slope_y.data(), blur_m}, count,
                  fineness.bias_m, fineness.in_plane, shares);
  for (int i = 0; i < count; ++i) {
    const bool free = horizon_.IsFreeAt(g_z[i]);
    if (free && shares[i] >= 0.0f) continue;
    const float over_ground =
        free ? 1.0f : horizon_.Share(p_GC_ + R_GC_ * Eigen::Vector3f(x[i], y[i], z[i]));
    if (over_ground == 0.0f || shares[i] >= 0.0f) {
      shares[i] = over_ground == 0.0f ? 0.0f : over_ground * shares[i];
      continue;
    }
    shares[i] = over_ground * shadow_.Partly({.p = {u_x[i], u_y[i], u_z[i]},
                                              .slopes = {at.slope_x[i], at.slope_y[i]},
                                              .bias_m = fineness.bias_m,
                                              .blur_m = blur_m[i],
                                              .pixel_x = first + i,
                                              .pixel_y = row.number,
                                              .in_plane = fineness.in_plane},
                                             fineness.searches, fineness.points);
  }
}

float ObjectShader::SunShare(Tan tan, float inverse_depth, const Eigen::Vector3f& n,
                             const Pixel& pixel) const {
  return Share(tan, inverse_depth, n, kCurvedBias_m, pixel, kSearches, kPoints);
}

float ObjectShader::Share(Tan tan, float inverse_depth, const Eigen::Vector3f& n, float bias,
                          const Pixel& pixel, int searches, int points, bool in_plane) const {
  const float z = 1.0f / inverse_depth;
  const Eigen::Vector3f p_C(z * tan.x, z * tan.y, z);
  const float over_ground = horizon_.Share(p_GC_ + R_GC_ * p_C);
  if (over_ground == 0.0f) return 0.0f;
  return over_ground * shadow_.Share({.p = p_UC_ + R_UC_ * p_C,
                                      .slopes = SunShadow::SlopesOf(n),
                                      .bias_m = bias,
                                      .blur_m = pixel.blur() * z,
                                      .pixel_x = pixel.column,
                                      .pixel_y = pixel.row,
                                      .in_plane = in_plane},
                                     searches, points);
}

}  // namespace dockyard
