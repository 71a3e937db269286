// How much light an image gets: by the image itself, or as it is asked for. No GL.
#pragma once

#include <span>

#include "render/kept_exposure.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Electrons of a pixel whose radiance is 1. images: the light on the sensors, exposed together.
double ElectronsOfRadiance(std::span<const RadianceImage> images, const SensorOptions& sensor);

/// The same by the image before, unless the exposure is fixed. The first one is exposed by itself.
/// A null `before` means by the images themselves. Afterwards it holds what these images' light
/// sets, without their stops; images without pixels leave it as it was.
double ElectronsOfRadiance(std::span<const RadianceImage> images, const SensorOptions& sensor,
                           KeptExposure* before);

}  // namespace dockyard
