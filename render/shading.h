// Lambert's law under sun, sky and the ground's bounce, for one channel of the image.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "render/scene.h"

namespace dockyard {

/// Grey is a panchromatic sensor's sum of linear red, green and blue.
enum class Channel { kGrey, kRed, kGreen, kBlue };

/// Share of red, green and blue in a channel. Grey: luminance weights of ITU-R BT.601.
Eigen::Vector3d ChannelWeights(Channel channel);
double Luminance(const Eigen::Vector3d& rgb);

/// Irradiance times albedo in one channel: from the sun on a surface facing it, from the whole sky,
/// from the ground's bounce. Divided by pi it is radiance.
struct Reflected {
  double sun = 0.0, sky = 0.0, bounce = 0.0;
};
/// The ground that bounces is level and in full light.
Reflected Reflect(const SunAndSky& light, const Eigen::Vector3d& albedo_rgb, Channel channel);

inline constexpr float kInversePi = 0.318309886f;

/// Radiance of a surface, a float or a colour: cosine of its normal to the sun and to the zenith.
template <typename Value>
Value Shade(const Value& sun, const Value& sky, const Value& bounce, float to_sun, float to_zenith,
            float share) {
  const Value around = 0.5f * (1.0f + to_zenith) * sky + 0.5f * (1.0f - to_zenith) * bounce;
  return kInversePi * (std::max(to_sun, 0.0f) * share * sun + around);
}

}  // namespace dockyard
