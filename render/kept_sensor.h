// What of lens and sensor is the same in all images of a camera. No GL.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/geometry/camera.h"
#include "render/kept_exposure.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Kept from image to image, as both cost more than what is done with them. Made anew where what
/// they follow from has changed, so that images do not depend on it.
class KeptSensor {
 public:
  /// The share of the light that the lens lets through to each pixel.
  const RadianceImage& Falloff(const Camera& camera, double exponent);
  /// Electrons of each of count pixels over their mean. pattern: the stream of ResponseOf.
  const std::vector<float>& Responses(std::uint64_t pattern, float sigma, std::size_t count);

 private:
  std::optional<Camera> camera_;  // of the falloff
  double exponent_ = 0.0;
  RadianceImage falloff_;
  std::uint64_t pattern_ = 0;
  float sigma_ = 0.0f;
  std::vector<float> responses_;
};

/// The same image as without what is kept, sooner. kept: of this camera, as `before` is, by which
/// the exposure is set where it is given (exposure_rule.h).
GrayImage ExposeGrey(RadianceImage radiance, const Camera& camera, const SensorOptions& sensor,
                     KeptSensor& kept, KeptExposure* before = nullptr);

/// Electrons of a pixel over their mean: the pixels differ among each other by sigma.
float ResponseOf(std::uint64_t pattern, float sigma, std::size_t pixel);

}  // namespace dockyard
