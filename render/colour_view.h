// A colour camera before its sensor, and the light that reaches the sensor.
#pragma once

#include <array>

#include "controller/geometry/camera.h"
#include "render/colour_table.h"
#include "render/lens_ripple.h"
#include "render/radiance_image.h"
#include "render/view_hole.h"

namespace dockyard {

struct ColourView {
  Camera camera;  // any lens with one centre, all pixels within 65 deg off the axis
  ViewHole hole{};
  double vignetting_exponent = 0.0;  // light falls off as cos^n of the angle off the axis
  // Rays along a pixel's side, but about the scene's Interest, which has more. 1 is enough for a
  // lens whose blur is as wide as a pixel.
  double rays = 2.0;
  LensRipple ripple{};  // of the lens

  bool operator==(const ColourView&) const = default;
};

/// Linear light, behind hole and falloff, before the lens's blur. It falls on a part of the image;
/// the rest, behind the hole's rim, is dark.
struct ColourRadiance {
  int width = 0, height = 0;            // of the whole image [px]
  int x0 = 0, y0 = 0;                   // where the part begins
  std::array<RadianceImage, 3> part{};  // red, green, blue, of one size
};

}  // namespace dockyard
