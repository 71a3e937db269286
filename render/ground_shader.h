// The ground's light for one camera, many pixels at a time. No GL.
#pragma once

#include <algorithm>

#include "render/ground_texture.h"
#include "render/scene.h"
#include "render/shading.h"
#include "render/sun_shadow.h"

namespace dockyard {

class GroundShader {
 public:
  static constexpr int kAtOnce = 64;

  /// texture and shadow must outlive this.
  GroundShader(const GroundTexture& texture, const Scene& scene, const SunShadow& shadow,
               const Pose3& X_WC, Channel channel);

  /// Pixels side by side in one row of the image that show the ground. Arrays of count:
  struct PixelRow {
    const float *x, *y;              // where each points in the tan plane
    const float *known_x, *known_y;  // a ray next to it
    const float* inverse_depth;      // 1/z of where that one meets the ground
    const float *along_x, *along_y;  // change of x, y from pixel to pixel
    const float *down_x, *down_y;    // the same from row to row
    int count;
    int column, row;  // of the first pixel

    /// kAtOnce pixels from one of them on, or what there is.
    PixelRow From(int first) const {
      return {x + first,
              y + first,
              known_x + first,
              known_y + first,
              inverse_depth + first,
              along_x + first,
              along_y + first,
              down_x + first,
              down_y + first,
              std::min(kAtOnce, count - first),
              column + first,
              row};
    }
  };
  /// Their radiance. A pixel's radiance does not depend on the other pixels.
  void operator()(const PixelRow& row, float* radiance) const;

  /// The same before any light has a strength or the ground a colour: radiance is the sum of
  /// factors times albedo times irradiance.
  struct Factors {
    float sun[kAtOnce], sky[kAtOnce], bounce[kAtOnce];
    float tone[kAtOnce];                             // of the grain, which sun, sky and bounce hold
    float n_x[kAtOnce], n_y[kAtOnce], n_z[kAtOnce];  // normal in the camera frame
    float z[kAtOnce];                                // depth [m]
  };
  /// Of at most kAtOnce pixels. sunlit: whether the sun shines at all.
  void FactorsOf(const PixelRow& row, bool sunlit, Factors& factors) const;

 private:
  struct Places;
  struct Lights;
  void Find(const PixelRow& row, int first, int count, Places& places) const;
  void Fetch(int count, const Places& places, Lights& lights) const;
  void Light(int count, Lights& lights) const;
  Four Relief(float x, float y, float column, float row, float lod) const;
  float SunShare(const PixelRow& row, int pixel, const Places& places, const Lights& lights,
                 int i) const;
  void Weigh(int count, const Lights& lights, Factors& factors) const;
  void Turn(const PixelRow& row, int first, int count, const Places& places, Lights& lights) const;

  const GroundTexture& texture_;
  const SunShadow& shadow_;
  Eigen::Vector2f p_GC_;
  Eigen::Matrix<float, 2, 3> to_level_;  // camera axes to the site's x and y
  Eigen::Matrix3f R_UC_, R_UG_, R_CG_;
  Eigen::Vector3f p_UC_, up_C_, sun_G_, up_G_;  // up_C_: off the ground; up_G_: to the zenith
  float x0_, y0_, per_cell_, cell_, cell_log_;
  float last_column_, last_row_;
  float sun_, sky_, bounce_;
};

}  // namespace dockyard
