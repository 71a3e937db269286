#include "render/colour_shader.h"

#include "render/ground_mesh.h"

namespace dockyard {
namespace {

Rgb Lambert(const MaterialLight::Lights& l, float to_sun, float to_zenith, float share) {
  return {Shade(l.sun.r, l.sky.r, l.bounce.r, to_sun, to_zenith, share),
          Shade(l.sun.g, l.sky.g, l.bounce.g, to_sun, to_zenith, share),
          Shade(l.sun.b, l.sky.b, l.bounce.b, to_sun, to_zenith, share)};
}

}  // namespace

ColourShader::ColourShader(const ColourLit& lit, const Pose3& X_WC)
    : lit_(lit),
      lights_(lit.scene, lit.colours, X_WC),
      objects_(lit.scene, lit.ground.highest_m(), lit.shadow, X_WC, Channel::kGrey),
      sky_(lit.scene, X_WC, Reflected{.sun = 1.0, .sky = 1.0, .bounce = 1.0}) {
  if (HasGround(lit.scene.ground)) {
    ground_.emplace(lit.ground, lit.scene, lit.shadow, X_WC, Channel::kGrey);
  }
  const Eigen::Matrix3d R_CU = X_WC.R.transpose() * lit.shadow.fit().X_WU.R;
  R_CU_ = R_CU.cast<float>();
  up_U_ = lit.shadow.fit().X_WU.R.row(2).transpose().cast<float>();
}

Rgb ColourShader::Sky(Tan tan) const {
  const SkyShader::Parts parts = sky_.PartsOf(tan);
  const MaterialLight::Lights& l = lights_.white();
  Rgb colour;
  colour.Add(l.sky, parts.sky);
  colour.Add(l.bounce, parts.bounce);
  colour.Add(l.sun, parts.sun);
  return colour;
}

void ColourShader::Ground(const GroundShader::PixelRow& row, Rgb* colours) const {
  GroundShader::Factors f;
  ground_->FactorsOf(row, lights_.sunlit(), f);
  const MaterialLight::Lights& l = lights_.of(lit_.scene.ground.material);
  for (int i = 0; i < row.count; ++i) {
    const float sun = lights_.sunlit() ? f.sun[i] : 0.0f;
    colours[i] = {sun * l.sun.r + f.sky[i] * l.sky.r + f.bounce[i] * l.bounce.r,
                  sun * l.sun.g + f.sky[i] * l.sky.g + f.bounce[i] * l.bounce.g,
                  sun * l.sun.b + f.sky[i] * l.sky.b + f.bounce[i] * l.bounce.b};
  }
  if (!lights_.has_lamps()) return;
  for (int i = 0; i < row.count; ++i) {
    const Eigen::Vector3f p_C(f.z[i] * row.x[i], f.z[i] * row.y[i], f.z[i]);
    lights_.AddLamps(l, p_C, {f.n_x[i], f.n_y[i], f.n_z[i]}, f.tone[i], colours[i]);
  }
}

Rgb ColourShader::GroundPart(const Met& met, const Pixel& pixel) const {
  Rgb colour;
  Ground({.x = &met.ray.x,
          .y = &met.ray.y,
          .known_x = &met.from.x,
          .known_y = &met.from.y,
          .inverse_depth = &met.code,
          .along_x = &pixel.along.x,
          .along_y = &pixel.along.y,
          .down_x = &pixel.down.x,
          .down_y = &pixel.down.y,
          .count = 1,
          .column = pixel.column,
          .row = pixel.row},
         &colour);
  return colour;
}

Rgb ColourShader::OfObject(const Met& met, const Pixel& pixel) const {
  const Eigen::Vector3f& n = met.normal;
  const int material = lit_.scene.objects[static_cast<std::size_t>(met.object)].material;
  const MaterialLight::Lights& l = lights_.of(material);
  float share = 0.0f;
  if (lights_.sunlit() && n.z() > 0.0f) {
    share = objects_.SunShare(met.from, met.code, n.normalized(), pixel);
  }
  Rgb colour = Lambert(l, n.z(), n.dot(up_U_), share);
  if (lights_.has_lamps()) {
    const float z = 1.0f / met.code;
    const Eigen::Vector3f p_C(z * met.from.x, z * met.from.y, z);
    lights_.AddLamps(l, p_C, R_CU_ * n, 1.0f, colour);
  }
  const auto object = static_cast<std::size_t>(met.object);
  if (lit_.scene.objects[object].stains.contrast > 0.0) {
    const float stain = objects_.Stain(object, met.from, met.ray, met.code, n, pixel);
    colour = {colour.r * stain, colour.g * stain, colour.b * stain};
  }
  return colour;
}

Rgb ColourShader::OfThin(std::size_t body, const Thin& sum, const Pixel& pixel,
                         const Rgb& behind) const {
  const float per = 1.0f / sum.cover, z = sum.cover / sum.inverse_depth;
  const MaterialLight::Lights& l = lights_.of(ThinBodies(lit_.scene)[body]->material);
  const float share = lights_.sunlit() ? objects_.SunShare(pixel.middle, sum.inverse_depth * per,
                                                           Eigen::Vector3f::UnitZ(), pixel)
                                       : 0.0f;
  Rgb thin = Lambert(l, sum.to_sun * per, sum.to_zenith * per, share);
  if (lights_.has_lamps()) {
    // Of the round body that faces the camera the mean cosine is pi / 4.
    const Eigen::Vector3f p_C(z * pixel.middle.x, z * pixel.middle.y, z);
    lights_.AddLamps(l, p_C, -p_C.normalized(), static_cast<float>(kPi / 4.0), thin);
  }
  Rgb colour;
  colour.Add(behind, 1.0f - sum.cover);
  colour.Add(thin, sum.cover);
  return colour;
}

}  // namespace dockyard
