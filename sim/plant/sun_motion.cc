#include "sim/plant/sun_motion.h"

#include <cmath>

#include "sim/scenario/sun_path.h"

namespace dockyard {

SunAndSky LightAt(const SunAndSky& start, const std::optional<Eigen::Vector3d>& to_pole_W,
                  double seconds) {
  constexpr double kHeld_s = 10.0;
  SunAndSky light = start;
  const double since_s = kHeld_s * std::floor(seconds / kHeld_s);
  if (!to_pole_W || since_s <= 0.0) return light;
  light.to_sun_W = SunAfter(light.to_sun_W, *to_pole_W, since_s);
  if (light.to_sun_W.z() > 0.0) return light;
  light.sun_irradiance = 0.0;
  light.to_sun_W = Eigen::Vector3d::UnitZ();  // of no effect: a direction that can be drawn
  return light;
}

}  // namespace dockyard
