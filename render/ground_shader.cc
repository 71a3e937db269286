#include "render/ground_shader.h"

#include <algorithm>
#include <cmath>

#include "controller/base/two_widths.h"

namespace dockyard {
namespace {

// A footprint on the ground is long and narrow: filtered by its length alone, the grain would blur
// away, and the walls of ruts with it.
constexpr float kSharper = 0.7f, kReliefSharper = 2.0f;
constexpr float kBias_m = 0.001f;
constexpr int kSearches = 4, kPoints = 8;  // of the sun's disc
constexpr float kFadeOut_m = 0.3f;         // of the relief beyond the grid's border
constexpr float kTexelLog = -9.3219281f;   // log2 of a texel of the soil's texture, 1.6 m / 1024
constexpr float kPerTile = static_cast<float>(1.0 / kSoilTile_m);
constexpr float kFull = static_cast<float>(kSoilSlopeFull);

}  // namespace

// The points of the ground in which pixels are shaded.
struct GroundShader::Places {
  float z[kAtOnce], x[kAtOnce], y[kAtOnce];  // depth; in the site's frame
  float column[kAtOnce], row[kAtOnce];       // of the grid
  float blur[kAtOnce];                       // half the footprint's width
  float soil_u[kAtOnce], soil_v[kAtOnce];    // in the soil's tiles
  float soil_lod[kAtOnce], relief_lod[kAtOnce];
};

// The ground in these points, and its light.
struct GroundShader::Lights {
  float relief_x[kAtOnce], relief_y[kAtOnce], over_ground[kAtOnce], lump_tone[kAtOnce];
  float tone[kAtOnce], slope_x[kAtOnce], slope_y[kAtOnce], height[kAtOnce];  // of the grain
  float sun[kAtOnce], around[kAtOnce];                                       // radiance
  float p_x[kAtOnce], p_y[kAtOnce], p_z[kAtOnce];
  float slope_u_x[kAtOnce], slope_u_y[kAtOnce];  // see SunShadow::Slopes
  float share[kAtOnce];                          // of the sun; -1: not told by bounds
};

GroundShader::GroundShader(const GroundTexture& texture, const Scene& scene,
                           const SunShadow& shadow, const Pose3& X_WC, Channel channel)
    : texture_(texture), shadow_(shadow) {
  const Pose3 X_UC = Inverse(shadow.fit().X_WU) * X_WC;
  R_UC_ = X_UC.R.cast<float>();
  p_UC_ = X_UC.p.cast<float>();
  R_UG_ = (shadow.fit().X_WU.R.transpose() * scene.ground.X_WG.R).cast<float>();
  R_CG_ = (X_WC.R.transpose() * scene.ground.X_WG.R).cast<float>();
  const GroundView& ground = scene.ground;
  const Pose3 X_GC = Inverse(ground.X_WG) * X_WC;
  p_GC_ = X_GC.p.head<2>().cast<float>();
  to_level_ = X_GC.R.topRows<2>().cast<float>();
  up_C_ = X_GC.R.row(2).transpose().cast<float>();
  sun_G_ = (ground.X_WG.R.transpose() * scene.light.to_sun_W).cast<float>();
  up_G_ = ground.X_WG.R.row(2).transpose().cast<float>();
  x0_ = static_cast<float>(ground.x0_m);
  y0_ = static_cast<float>(ground.y0_m);
  cell_ = static_cast<float>(ground.cell_m);
  per_cell_ = 1.0f / cell_;
  cell_log_ = RoughLog2(cell_);
  last_column_ = static_cast<float>(ground.nx - 1);
  last_row_ = static_cast<float>(ground.ny - 1);
  const Reflected r = Reflect(scene.light, ground.albedo, channel);
  sun_ = static_cast<float>(r.sun);
  sky_ = static_cast<float>(r.sky);
  bounce_ = static_cast<float>(r.bounce);
}

void GroundShader::operator()(const PixelRow& row, float* radiance) const {
  Places places;
  Lights lights;
  for (int first = 0; first < row.count; first += kAtOnce) {
    const int count = std::min(kAtOnce, row.count - first);
    Find(row, first, count, places);
    Fetch(count, places, lights);
    Light(count, lights);
    Turn(row, first, count, places, lights);
    shadow_.PlainOf({.p_x = lights.p_x,
                     .p_y = lights.p_y,
                     .p_z = lights.p_z,
                     .slope_x = lights.slope_u_x,
                     .slope_y = lights.slope_u_y},
                    count, kBias_m, false, lights.share);
    for (int i = 0; i < count; ++i) {
      float share = lights.sun[i] > 0.0f ? lights.share[i] : 0.0f;
      if (share < 0.0f) share = SunShare(row, first + i, places, lights, i);
      radiance[first + i] = lights.around[i] + share * lights.sun[i];
    }
  }
}

void GroundShader::FactorsOf(const PixelRow& row, bool sunlit, Factors& factors) const {
  Places places;
  Lights lights;
  Find(row, 0, row.count, places);
  Fetch(row.count, places, lights);
  Weigh(row.count, lights, factors);
  std::copy(places.z, places.z + row.count, factors.z);
  if (!sunlit) return;
  Turn(row, 0, row.count, places, lights);
  shadow_.PlainOf({.p_x = lights.p_x,
                   .p_y = lights.p_y,
                   .p_z = lights.p_z,
                   .slope_x = lights.slope_u_x,
                   .slope_y = lights.slope_u_y},
                  row.count, kBias_m, false, lights.share);
  for (int i = 0; i < row.count; ++i) {
    float share = factors.sun[i] > 0.0f ? lights.share[i] : 0.0f;
    if (share < 0.0f) share = SunShare(row, i, places, lights, i);
    factors.sun[i] *= share;
  }
}

// Share of the sun that objects leave a pixel, by points.
float GroundShader::SunShare(const PixelRow& row, int pixel, const Places& places,
                             const Lights& lights, int i) const {
  SunShadow::Place place{.p = {lights.p_x[i], lights.p_y[i], lights.p_z[i]},
                         .slopes = {lights.slope_u_x[i], lights.slope_u_y[i]},
                         .bias_m = kBias_m,
                         .blur_m = places.blur[i],
                         .pixel_x = row.column + pixel,
                         .pixel_y = row.row};
  const Eigen::Vector3f ray(row.x[pixel], row.y[pixel], 1.0f);
  const Eigen::Vector3f along(row.along_x[pixel], row.along_y[pixel], 0.0f);
  const Eigen::Vector3f down(row.down_x[pixel], row.down_y[pixel], 0.0f);
  const float tilt_a = up_C_.dot(along), tilt_d = up_C_.dot(down);
  const bool a_is_longer = std::abs(tilt_a) > std::abs(tilt_d);
  const Eigen::Vector3f& step = a_is_longer ? along : down;
  const float deeper = -(a_is_longer ? tilt_a : tilt_d) / std::min(up_C_.dot(ray), -1e-3f);
  const Eigen::Vector3f length = places.z[i] * (step + deeper * ray);
  if (length.norm() > 4.0f * place.blur_m) place.length = R_UC_ * length;
  return shadow_.Partly(place, kSearches, kPoints);
}

DOCKYARD_TWO_WIDTHS
void GroundShader::Find(const PixelRow& l, int first, int count, Places& p) const {
  const float ux = up_C_.x(), uy = up_C_.y(), uz = up_C_.z();
  const Eigen::Matrix<float, 2, 3> m = to_level_;
  const float px = p_GC_.x(), py = p_GC_.y();
  for (int i = 0; i < count; ++i) {
    const float x = l.x[first + i], y = l.y[first + i];
    const float ax = l.along_x[first + i], ay = l.along_y[first + i];
    const float dx = l.down_x[first + i], dy = l.down_y[first + i];
    // On level ground depths go inversely with how much a ray sinks in a metre of depth.
    const float sinks = std::min(ux * x + uy * y + uz, -1e-3f);
    const float known_sinks =
        std::min(ux * l.known_x[first + i] + uy * l.known_y[first + i] + uz, -1e-3f);
    const float z = known_sinks / (sinks * l.inverse_depth[first + i]);
    // The footprint on level ground: a step that changes the sinking moves the point along the ray
    // in proportion.
    const float tilt = std::max(std::abs(ux * ax + uy * ay), std::abs(ux * dx + uy * dy));
    const float width = z * std::max(std::abs(ax) + std::abs(ay), std::abs(dx) + std::abs(dy));
    const float length = std::max(z * tilt / -sinks * (1.0f + std::abs(x)), width);
    const float length_log = RoughLog2(length);
    p.z[i] = z;
    p.x[i] = px + z * (m(0, 0) * x + m(0, 1) * y + m(0, 2));
    p.y[i] = py + z * (m(1, 0) * x + m(1, 1) * y + m(1, 2));
    p.column[i] = (p.x[i] - x0_) * per_cell_;
    p.row[i] = (p.y[i] - y0_) * per_cell_;
    p.blur[i] = 0.5f * width;
    p.soil_u[i] = p.x[i] * kPerTile;
    p.soil_v[i] = p.y[i] * kPerTile;
    p.soil_lod[i] = length_log - (kTexelLog + kSharper);
    p.relief_lod[i] = std::max(RoughLog2(width), length_log - kReliefSharper) - cell_log_;
  }
}

Four GroundShader::Relief(float x, float y, float column, float row, float lod) const {
  const float beyond = cell_ * std::max(std::max(std::max(-column, column - last_column_),
                                                 std::max(-row, row - last_row_)),
                                        0.0f);
  if (beyond >= kFadeOut_m) return texture_.Beyond(x, y);
  const Four relief = texture_.relief().At(column - 0.5f, row - 0.5f, lod);
  if (beyond == 0.0f) return relief;
  const float t = beyond * (1.0f / kFadeOut_m);
  return Mix(relief, texture_.Beyond(x, y), t * t * (3.0f - 2.0f * t));
}

DOCKYARD_TWO_WIDTHS
void GroundShader::Fetch(int count, const Places& p, Lights& l) const {
  for (int i = 0; i < count && !texture_.plain(); ++i) {
    const Four relief = Relief(p.x[i], p.y[i], p.column[i], p.row[i], p.relief_lod[i]);
    l.relief_x[i] = relief[0];
    l.relief_y[i] = relief[1];
    l.over_ground[i] = relief[2];
    l.lump_tone[i] = relief[3];
  }
  if (texture_.plain()) {
    std::fill(l.relief_x, l.relief_x + count, 0.0f);
    std::fill(l.relief_y, l.relief_y + count, 0.0f);
    std::fill(l.over_ground, l.over_ground + count, 1.0f);
    std::fill(l.lump_tone, l.lump_tone + count, 1.0f);
  }
  if (texture_.grain() == 0.0f) {
    for (float* values : {l.tone, l.slope_x, l.slope_y, l.height}) {
      std::fill(values, values + count, 0.0f);
    }
    return;
  }
  static_assert(kAtOnce <= SoilPyramid::kAtOnce);
  Four texels[kAtOnce];
  texture_.soil().At(p.soil_u, p.soil_v, p.soil_lod, count, texels);
  for (int i = 0; i < count; ++i) {
    const Four grain = texture_.grain() * GroundTexture::Signed(texels[i]);
    l.tone[i] = grain[0];
    l.slope_x[i] = grain[1];
    l.slope_y[i] = grain[2];
    l.height[i] = grain[3];
  }
}

DOCKYARD_TWO_WIDTHS
void GroundShader::Light(int count, Lights& l) const {
  const float sun_x = sun_G_.x(), sun_y = sun_G_.y(), sun_z = sun_G_.z();
  const float up_x = up_G_.x(), up_y = up_G_.y(), up_z = up_G_.z();
  for (int i = 0; i < count; ++i) {
    const float sx = l.relief_x[i] + kFull * l.slope_x[i];
    const float sy = l.relief_y[i] + kFull * l.slope_y[i];
    const float shorten = 1.0f / std::sqrt(1.0f + sx * sx + sy * sy);
    const float to_sun = (sun_z - sx * sun_x - sy * sun_y) * shorten;
    const float to_zenith = (up_z - sx * up_x - sy * up_y) * shorten;
    const float tone = (1.0f + l.tone[i]) * l.lump_tone[i];
    // Grain holds back some of the sky.
    const float open = std::min(std::max(0.92f + 0.5f * l.height[i], 0.7f), 1.0f);
    l.around[i] = tone * Shade(sun_, sky_ * open, bounce_ * open, 0.0f, to_zenith, 0.0f);
    l.sun[i] = tone * kInversePi * sun_ * std::max(to_sun, 0.0f) * l.over_ground[i];
  }
}

// Light's twin without strengths.
DOCKYARD_TWO_WIDTHS
void GroundShader::Weigh(int count, const Lights& l, Factors& f) const {
  const float sun_x = sun_G_.x(), sun_y = sun_G_.y(), sun_z = sun_G_.z();
  const float up_x = up_G_.x(), up_y = up_G_.y(), up_z = up_G_.z();
  const Eigen::Matrix3f m = R_CG_;
  const float shut = 1.0f - 0.08f * texture_.grain();  // no grain, no shade of it
  for (int i = 0; i < count; ++i) {
    const float sx = l.relief_x[i] + kFull * l.slope_x[i];
    const float sy = l.relief_y[i] + kFull * l.slope_y[i];
    const float shorten = 1.0f / std::sqrt(1.0f + sx * sx + sy * sy);
    const float to_sun = (sun_z - sx * sun_x - sy * sun_y) * shorten;
    const float to_zenith = (up_z - sx * up_x - sy * up_y) * shorten;
    const float open = std::min(std::max(shut + 0.5f * l.height[i], 0.7f), 1.0f);
    const float tone = (1.0f + l.tone[i]) * l.lump_tone[i];
    f.tone[i] = tone;
    f.sun[i] = tone * kInversePi * std::max(to_sun, 0.0f) * l.over_ground[i];
    f.sky[i] = tone * kInversePi * open * 0.5f * (1.0f + to_zenith);
    f.bounce[i] = tone * kInversePi * open * 0.5f * (1.0f - to_zenith);
    f.n_x[i] = (m(0, 2) - sx * m(0, 0) - sy * m(0, 1)) * shorten;
    f.n_y[i] = (m(1, 2) - sx * m(1, 0) - sy * m(1, 1)) * shorten;
    f.n_z[i] = (m(2, 2) - sx * m(2, 0) - sy * m(2, 1)) * shorten;
  }
}

// Places and slopes in light axes.
DOCKYARD_TWO_WIDTHS
void GroundShader::Turn(const PixelRow& row, int first, int count, const Places& p,
                        Lights& l) const {
  const Eigen::Matrix3f m = R_UC_, r = R_UG_;
  const Eigen::Vector3f o = p_UC_;
  for (int i = 0; i < count; ++i) {
    const float x = p.z[i] * row.x[first + i], y = p.z[i] * row.y[first + i];
    l.p_x[i] = o[0] + (m(0, 0) * x + m(0, 1) * y + m(0, 2) * p.z[i]);
    l.p_y[i] = o[1] + (m(1, 0) * x + m(1, 1) * y + m(1, 2) * p.z[i]);
    l.p_z[i] = o[2] + (m(2, 0) * x + m(2, 1) * y + m(2, 2) * p.z[i]);
  }
  for (int i = 0; i < count; ++i) {
    const float sx = -l.relief_x[i], sy = -l.relief_y[i];
    const float least = SunShadow::kLeastCosine * std::sqrt(1.0f + sx * sx + sy * sy);
    const float per_z = -1.0f / std::max(r(2, 0) * sx + r(2, 1) * sy + r(2, 2), least);
    l.slope_u_x[i] = (r(0, 0) * sx + r(0, 1) * sy + r(0, 2)) * per_z;
    l.slope_u_y[i] = (r(1, 0) * sx + r(1, 1) * sy + r(1, 2)) * per_z;
  }
}

}  // namespace dockyard
