#include "sim/scenario/sun_keys.h"

#include <cmath>

#include "sim/scenario/sun_path.h"

namespace dockyard {
namespace {

void VisitPath(Keys& keys, Light light, SunModel& sun) {
  keys.Bool(
      {"moving", "", "whether it crosses the sky during the run, from its place at the start"},
      sun.moving);
  keys.Check("moving", !sun.moving || light != Light::kRoom, "false in a room");
  keys.Degrees({"latitude_deg", "deg", "of a moving sun: the yard's on the Earth, north positive"},
               sun.latitude_rad, Between(-66.0, 66.0));
  keys.Degrees({"north_deg", "deg",
                "the same: azimuth of the north; none: the sun is due south at the start, due "
                "north where the latitude is negative",
                Presence::kUnset},
               sun.north_rad, Between(-180.0, 180.0));
  const bool placed = !std::isnan(sun.azimuth_rad) && !std::isnan(sun.elevation_rad);
  keys.Check("north_deg", !sun.moving || std::isnan(sun.north_rad) || placed,
             "azimuth_deg and elevation_deg next to it");
  keys.Check("moving", HasASeason(sun),
             "a sun within 23.45 deg of the celestial equator, by its place and the latitude");
}

}  // namespace

void VisitSun(Keys& keys, Light light, SunModel& sun) {
  using enum Presence;
  keys.Degrees({"azimuth_deg", "deg", "from the way the target faces; none: random", kUnset},
               sun.azimuth_rad, Between(-180.0, 180.0));
  keys.Degrees({"elevation_deg", "deg", "above the level; none: random", kUnset}, sun.elevation_rad,
               Between(2.0, 90.0));
  // The Planckian locus is known from 1667 to 25000 K.
  keys.Number({"temperature_k", "K", "colour of the sun; none: white", kUnset}, sun.temperature_k,
              Between(1667.0, 25000.0));
  keys.Number({"sky_temperature_k", "K", "colour of the sky; none: white", kUnset},
              sun.sky_temperature_k, Between(1667.0, 25000.0));
  keys.Number({"opacity", "",
               "optical depth of the air, by which the light follows the sun's height; none: the "
               "kind of light states it",
               kUnset},
              sun.opacity, Between(0.0, 10.0));
  keys.Check("opacity", std::isnan(sun.opacity) || light != Light::kRoom, "no opacity in a room");
  VisitPath(keys, light, sun);
}

}  // namespace dockyard
