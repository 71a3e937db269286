// The sun's place by date, hour and latitude on the Earth. Frame L: sun_path.h.
#pragma once

#include <optional>
#include <string>

#include "sim/scenario/scenario.h"

namespace dockyard {

/// A day of the year 2013. In another year its declination differs by up to 0.2 deg, by leap days.
struct SunDate {
  int month = 1, day = 1;
};
/// Of "06-21"; none if the text is no month and day of that year.
std::optional<SunDate> ParseSunDate(const std::string& text);

/// Days from the epoch J2000.0 (2000 January 1, 12 h) to that day's hour, 0 to 24.
double DaysFrom2000(const SunDate& date, double hour);

/// The sun's apparent declination [rad] on this day from J2000.0. J. Meeus, Astronomical
/// Algorithms (2nd ed., 1998), ch. 25, low accuracy: 0.01 deg.
double SunDeclination_rad(double days);

/// Whether date and hour state the sun's place.
bool HasADate(const SunModel& sun);
/// The elevation [rad] of a sun with a date: sin h = sin phi sin delta + cos phi cos delta cos H.
/// The hour counts as Universal Time in the declination, which is off by 0.2 deg at most.
double DatedElevation_rad(const SunModel& sun);
/// The model with azimuth and elevation by date, hour, latitude and north; one without a date as it
/// is.
SunModel PlacedByDate(SunModel sun);

}  // namespace dockyard
