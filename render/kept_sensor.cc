#include "render/kept_sensor.h"

#include <algorithm>

#include "render/optics.h"
#include "render/pixel_noise.h"

namespace dockyard {

float ResponseOf(std::uint64_t pattern, float sigma, std::size_t pixel) {
  return std::max(1.0f + sigma * HashNormal(pattern, pixel), 0.0f);
}

const RadianceImage& KeptSensor::Falloff(const Camera& camera, double exponent) {
  if (!camera_ || !(*camera_ == camera) || exponent_ != exponent) {
    falloff_ = FalloffOf(camera, exponent);
    camera_ = camera;
    exponent_ = exponent;
  }
  return falloff_;
}

const std::vector<float>& KeptSensor::Responses(std::uint64_t pattern, float sigma,
                                                std::size_t count) {
  if (pattern_ != pattern || sigma_ != sigma || responses_.size() != count) {
    responses_.resize(count);
    for (std::size_t i = 0; i < count; ++i) responses_[i] = ResponseOf(pattern, sigma, i);
    pattern_ = pattern;
    sigma_ = sigma;
  }
  return responses_;
}

}  // namespace dockyard
