#include "render/shadow.h"

#include "render/shaders.h"

namespace dockyard {
namespace {

GlTexture& Prepared(GlTexture& texture, int width, int height) {
  texture.Image(GL_DEPTH_COMPONENT32F, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  texture.Sampling(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
  return texture;
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

}  // namespace

ShadowMap::ShadowMap(const GlFunctions& gl)
    : gl_(gl),
      depth_(gl),
      depth_target_(gl, nullptr, &Prepared(depth_, width_, height_)),
      depth_program_(gl, PlainVertexShader(), DepthFragmentShader()) {}

void ShadowMap::Render(const ShadowFit& fit, double sun_angular_diameter_rad,
                       const DrawCasters& draw, SunShadow& shadow) {
  const int width = AtlasWidth(fit.coarse.texels, fit.fine.texels), height = fit.coarse.texels;
  if (width != width_ || height != height_) Prepared(depth_, width_ = width, height_ = height);
  depth_target_.Bind(width, height);
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
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  shadow.Resize(fit);
  gl_.ReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, shadow.depth().data());
  shadow.Take(fit, sun_angular_diameter_rad);
}

}  // namespace dockyard
