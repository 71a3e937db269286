// The lens's effects on an ideal view before its light reaches the sensor: defocus, falloff, blur.
#pragma once

#include "render/gauss_blur.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Blur circle on the sensor of a point at depth z_m [px]; thin lens, c = f^2/N |z - zf| / (z (zf -
/// f)) (e.g. Ray, Applied Photographic Optics). 0 when the focus distance is 0: all is sharp.
double BlurCircle_px(const Focus& focus, double z_m);

/// Checks that the options are a lens's.
void CheckOptics(const SensorOptions& sensor);

/// Share of the light that the lens lets through to each pixel.
RadianceImage FalloffOf(const Camera& camera, double exponent);

/// Defocus needs the view's depths. falloff: FalloffOf, where it is known.
void ApplyOptics(const Camera& camera, const SensorOptions& sensor, RadianceImage& image,
                 const RadianceImage* falloff = nullptr);

}  // namespace dockyard
