// The ground's shadow on the things above it. No GL.
#pragma once

#include "render/scene.h"

namespace dockyard {

class GroundHorizon {
 public:
  /// The scene must outlive this. highest_m: of its ground.
  GroundHorizon(const Scene& scene, double highest_m);
  /// Share of the sun's disc over the ground's horizon, seen from a point of the site frame.
  float Share(const Eigen::Vector3f& p_G) const;
  /// Whether a point this high sees the whole disc, because the sun's ray leaves the ground's
  /// highest place below it within a cell.
  bool IsFreeAt(float z_m) const {
    const auto cell = static_cast<float>(ground_.cell_m);
    return z_m + cell * slope_ > highest_m_ + 2.0f * sun_rise_ * cell;
  }

 private:
  const GroundView& ground_;
  float highest_m_ = -1e9f, sun_rise_ = 0.0f;
  Eigen::Vector2f level_{0, 0};  // towards the sun, length 1
  float slope_ = 0.0f;           // of the sun's rays; sun_rise_: of the disc's rim against that
};

}  // namespace dockyard
