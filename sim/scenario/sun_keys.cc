#include "sim/scenario/sun_keys.h"

#include <cmath>
#include <cstdio>

#include "sim/scenario/sun_date.h"
#include "sim/scenario/sun_path.h"

namespace dockyard {
namespace {

// The least elevation of a sun that the scenario places.
constexpr double kLeastElevation_deg = 2.0;

/// The sun's place by date and hour; north and latitude are read.
void CheckDate(Keys& keys, Light light, const SunModel& sun) {
  const bool dated = !sun.date.empty(), timed = !std::isnan(sun.hour);
  keys.Check("date", !dated || ParseSunDate(sun.date).has_value(), "a month and a day, as '06-21'");
  keys.Check("date", !dated || light != Light::kRoom, "no date in a room");
  keys.Check("date", !dated || timed, "hour next to it");
  keys.Check("hour", !timed || dated, "date next to it");
  keys.Check("date", !dated || !std::isnan(sun.north_rad), "north_deg next to it");
  keys.Allow("azimuth_deg", !dated, "either azimuth_deg and elevation_deg or date and hour");
  keys.Allow("elevation_deg", !dated, "either azimuth_deg and elevation_deg or date and hour");
  if (!HasADate(sun) || !ParseSunDate(sun.date)) return;
  const double elevation_deg = Degrees(DatedElevation_rad(sun));
  char found[60];
  std::snprintf(found, sizeof found, "a sun %.1f deg high", elevation_deg);
  keys.Check("hour", elevation_deg >= kLeastElevation_deg,
             "an hour at which the sun is at least 2 deg high", found);
}

void VisitPath(Keys& keys, Light light, SunModel& sun) {
  keys.Bool(
      {"moving", "", "whether it crosses the sky during the run, from its place at the start"},
      sun.moving);
  keys.Check("moving", !sun.moving || light != Light::kRoom, "false in a room");
  keys.Degrees({"latitude_deg", "deg",
                "of a sun that moves or has a date: the yard's on the Earth, north positive"},
               sun.latitude_rad, Between(-66.0, 66.0));
  keys.Degrees({"north_deg", "deg",
                "the same: azimuth of the north; none: the sun is due south at the start, due "
                "north where the latitude is negative",
                Presence::kUnset},
               sun.north_rad, Between(-180.0, 180.0));
  keys.Text({"date", "", "month and day, as '06-21', instead of the two angles", Presence::kUnset},
            sun.date);
  keys.Number({"hour", "h", "the same: local solar time, 12 when the sun is in the meridian",
               Presence::kUnset},
              sun.hour, Between(0.0, 24.0));
  CheckDate(keys, light, sun);
  const bool placed =
      HasADate(sun) || (!std::isnan(sun.azimuth_rad) && !std::isnan(sun.elevation_rad));
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
               Between(kLeastElevation_deg, 90.0));
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
