#include "sim/plant/sun_motion.h"

#include <algorithm>
#include <cmath>

#include "sim/plant/opacity.h"
#include "sim/scenario/sun_path.h"

namespace dockyard {
namespace {

// Lower than this the sky keeps its light: a plane-parallel air would take all of it at sunset.
constexpr double kLeastForSky_rad = Radians(2.0);

/// Sun and sky at another height. As ratios, so that a scale of the light's own stays.
void Fade(double from_rad, double to_rad, SunAndSky& light) {
  const auto at = [&](double elevation_rad) {
    return LightThroughAir(light.opacity, elevation_rad);
  };
  light.sun_irradiance *= at(std::max(to_rad, 0.0)).sun / at(from_rad).sun;
  const double sky = at(std::max(from_rad, kLeastForSky_rad)).sky;
  if (sky > 0.0) light.sky_irradiance *= at(std::max(to_rad, kLeastForSky_rad)).sky / sky;
}

}  // namespace

SunAndSky LightAt(const SunAndSky& start, const std::optional<Eigen::Vector3d>& to_pole_W,
                  double seconds) {
  constexpr double kHeld_s = 10.0;
  SunAndSky light = start;
  const double since_s = kHeld_s * std::floor(seconds / kHeld_s);
  if (!to_pole_W || since_s <= 0.0) return light;
  light.to_sun_W = SunAfter(light.to_sun_W, *to_pole_W, since_s);
  if (!std::isnan(light.opacity)) {
    Fade(std::asin(start.to_sun_W.z()), std::asin(light.to_sun_W.z()), light);
  }
  if (light.to_sun_W.z() > 0.0) return light;
  light.sun_irradiance = 0.0;
  light.to_sun_W = Eigen::Vector3d::UnitZ();  // of no effect: a direction that can be drawn
  return light;
}

}  // namespace dockyard
