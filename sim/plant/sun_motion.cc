#include "sim/plant/sun_motion.h"

#include <cmath>

#include "sim/scenario/sun_path.h"

namespace dockyard {

SunAndSky LightAt(const Lighting& lighting, double seconds) {
  constexpr double kHeld_s = 10.0;
  SunAndSky light = lighting.sun_and_sky;
  const double since_s = kHeld_s * std::floor(seconds / kHeld_s);
  if (!lighting.to_pole_W || since_s <= 0.0) return light;
  light.to_sun_W = SunAfter(light.to_sun_W, *lighting.to_pole_W, since_s);
  if (light.to_sun_W.z() > 0.0) return light;
  light.sun_irradiance = 0.0;
  light.to_sun_W = Eigen::Vector3d::UnitZ();  // of no effect: a direction that can be drawn
  return light;
}

}  // namespace dockyard
