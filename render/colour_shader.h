// Colours of ground, objects, cables and sky for one camera: shares of the lights times the
// materials' colours in them. No GL.
#pragma once

#include <optional>
#include <vector>

#include "render/compose_colour.h"
#include "render/ground_shader.h"
#include "render/material_light.h"
#include "render/object_shader.h"
#include "render/ray_source.h"
#include "render/sky_shader.h"

namespace dockyard {

class ColourShader {
 public:
  /// lit must outlive this.
  ColourShader(const ColourLit& lit, const Pose3& X_WC);

  Rgb Sky(Tan tan) const;
  /// Of at most GroundShader::kAtOnce pixels side by side.
  void Ground(const GroundShader::PixelRow& row, Rgb* colours) const;
  /// Of the ground that some rays of a pixel met; met: their means.
  Rgb GroundPart(const Met& met, const Pixel& pixel) const;
  /// Of an object. Lambert's law is linear in the normal, so the mean one serves for all rays,
  /// unless some of them meet faces that are turned away from a light.
  Rgb OfObject(const Met& met, const Pixel& pixel) const;
  /// Of one of the scene's ThinBodies, whole; behind: what lies behind it.
  Rgb OfThin(std::size_t body, const Thin& thin, const Pixel& pixel, const Rgb& behind) const;

 private:
  const ColourLit& lit_;
  MaterialLight lights_;
  ObjectShader objects_;
  std::optional<GroundShader> ground_;
  SkyShader sky_;  // of lights of strength 1
  Eigen::Matrix3f R_CU_;
  Eigen::Vector3f up_U_;
};

}  // namespace dockyard
