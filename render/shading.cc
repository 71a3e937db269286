#include "render/shading.h"

namespace dockyard {

Eigen::Vector3d ChannelWeights(Channel channel) {
  switch (channel) {
    case Channel::kRed:
      return {1, 0, 0};
    case Channel::kGreen:
      return {0, 1, 0};
    case Channel::kBlue:
      return {0, 0, 1};
    case Channel::kGrey:
      break;
  }
  return {0.299, 0.587, 0.114};
}

double Luminance(const Eigen::Vector3d& rgb) { return rgb.dot(ChannelWeights(Channel::kGrey)); }

Reflected Reflect(const SunAndSky& light, const Eigen::Vector3d& albedo_rgb, Channel channel) {
  const Eigen::Vector3d weighted = albedo_rgb.cwiseProduct(ChannelWeights(channel));
  const Eigen::Vector3d sun = light.sun_irradiance * light.sun_rgb;
  const Eigen::Vector3d sky = light.sky_irradiance * light.sky_rgb;
  const Eigen::Vector3d on_level = std::max(light.to_sun_W.z(), 0.0) * sun + sky;
  return {.sun = weighted.dot(sun),
          .sky = weighted.dot(sky),
          .bounce = light.ground_bounce_albedo * weighted.dot(on_level)};
}

}  // namespace dockyard
