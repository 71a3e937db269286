// The sun's shadow map: two windows in one texture, a fine one round the board and a coarse one
// over everything near.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "render/gl_objects.h"
#include "render/sun_shadow.h"

namespace dockyard {

class ShadowMap {
 public:
  explicit ShadowMap(const GlFunctions& gl);

  /// Draws all casters through the program given to it.
  using DrawCasters = std::function<void(GlProgram&, const Eigen::Matrix4d& clip_from_U,
                                         const ShadowWindow& window)>;
  void Render(const ShadowFit& fit, double sun_angular_diameter_rad, const DrawCasters& draw,
              SunShadow& shadow);

 private:
  const GlFunctions& gl_;
  int width_ = kAtlasWidth, height_ = kAtlasHeight;
  GlTexture depth_;
  GlTextureTarget depth_target_;
  GlProgram depth_program_;
};

}  // namespace dockyard
