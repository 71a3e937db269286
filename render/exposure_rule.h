// How much light an image gets: by the image itself, or as it is asked for. No GL.
#pragma once

#include <span>

#include "render/stereo_renderer.h"

namespace dockyard {

/// Electrons of a pixel whose radiance is 1. images: the light on the sensors, exposed together.
double ElectronsOfRadiance(std::span<const RadianceImage> images, const SensorOptions& sensor);

}  // namespace dockyard
