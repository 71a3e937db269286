// The sky's radiance for one camera. No GL.
#pragma once

#include <cmath>

#include "render/flat_view.h"
#include "render/scene.h"
#include "render/shading.h"

namespace dockyard {

/// Sky twice as bright at the horizon as overhead (assumed, 1-3 for a clear sky); over the level
/// surface it adds up to the whole sky's irradiance: 2 * integral of 0.75 (2 - s) s ds = 1.
class SkyShader {
 public:
  /// r: what a white surface would send back.
  SkyShader(const Scene& scene, const Pose3& X_WC, const Reflected& r)
      : up_C_(X_WC.R.row(2).transpose().cast<float>()),
        sun_C_((X_WC.R.transpose() * scene.light.to_sun_W).cast<float>()) {
    const double radius = 0.5 * scene.light.sun_angular_diameter_rad;
    sky_ = static_cast<float>(r.sky) * kInversePi;
    bounce_ = static_cast<float>(r.bounce) * kInversePi;
    near_sun_ = static_cast<float>(std::cos(radius));
    if (radius > 0.0) disc_ = static_cast<float>(r.sun / (kPi * radius * radius));
  }
  /// Shares of the light in what is seen along a ray: of the sky, of the bounce, of the sun's disc.
  struct Parts {
    float sky = 0.0f, bounce = 0.0f, sun = 0.0f;
  };
  Parts PartsOf(Tan tan) const {
    const float shorten = 1.0f / std::sqrt(1.0f + tan.x * tan.x + tan.y * tan.y);
    const float s = (up_C_.x() * tan.x + up_C_.y() * tan.y + up_C_.z()) * shorten;
    const float cosine = (sun_C_.x() * tan.x + sun_C_.y() * tan.y + sun_C_.z()) * shorten;
    return {.sky = s > 0.0f ? sky_ * 0.75f * (2.0f - s) : 0.0f,
            .bounce = s > 0.0f ? 0.0f : bounce_,
            .sun = cosine > near_sun_ ? disc_ : 0.0f};
  }
  float operator()(Tan tan) const {
    const float shorten = 1.0f / std::sqrt(1.0f + tan.x * tan.x + tan.y * tan.y);
    const float s = (up_C_.x() * tan.x + up_C_.y() * tan.y + up_C_.z()) * shorten;
    const float cosine = (sun_C_.x() * tan.x + sun_C_.y() * tan.y + sun_C_.z()) * shorten;
    const float sky = s > 0.0f ? sky_ * 0.75f * (2.0f - s) : bounce_;
    return cosine > near_sun_ ? sky + disc_ : sky;
  }

 private:
  Eigen::Vector3f up_C_, sun_C_;
  float sky_, bounce_, near_sun_, disc_ = 0.0f;
};

}  // namespace dockyard
