// The light of one lamp on surfaces before one camera, without shadows. No GL.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "render/scene.h"
#include "render/shading.h"

namespace dockyard {

class LampLight {
 public:
  LampLight(const Lamp& lamp, const Pose3& X_WC)
      : p_C_((X_WC.R.transpose() * (lamp.p_W - X_WC.p)).cast<float>()),
        axis_C_((X_WC.R.transpose() * lamp.axis_W).cast<float>()),
        per_pi_(static_cast<float>(lamp.irradiance_1m) * kInversePi),
        power_(lamp.half_angle_rad > 0.0
                   ? static_cast<float>(std::log(0.5) / std::log(std::cos(lamp.half_angle_rad)))
                   : 0.0f) {}

  /// Irradiance over pi of a surface at p_C with the normal n_C.
  float operator()(const Eigen::Vector3f& p_C, const Eigen::Vector3f& n_C) const {
    const Eigen::Vector3f to_lamp = p_C_ - p_C;
    const float per_away = 1.0f / std::sqrt(std::max(to_lamp.squaredNorm(), 1e-6f));
    const float cosine = n_C.dot(to_lamp) * per_away;
    if (cosine <= 0.0f) return 0.0f;
    float beam = 1.0f;
    if (power_ > 0.0f) {
      const float off = -axis_C_.dot(to_lamp) * per_away;
      if (off <= 0.0f) return 0.0f;
      beam = std::pow(off, power_);
    }
    return per_pi_ * beam * cosine * per_away * per_away;
  }

 private:
  Eigen::Vector3f p_C_, axis_C_;
  float per_pi_, power_;
};

}  // namespace dockyard
