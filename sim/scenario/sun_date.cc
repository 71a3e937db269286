#include "sim/scenario/sun_date.h"

#include <cctype>
#include <cmath>

#include "sim/scenario/sun_path.h"

namespace dockyard {
namespace {

constexpr int kDaysBefore[13] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334, 365};
// From the epoch J2000.0 (2000 January 1, 12 h) to 2013 January 1, 0 h.
constexpr double kDaysTo2013 = 4748.5;

bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// In frame L with the north at azimuth 0.
Eigen::Vector3d ToSunFromNorth(const SunModel& sun) {
  const std::optional<SunDate> date = ParseSunDate(sun.date);
  const double declination_rad =
      SunDeclination_rad(DaysFrom2000(date.value_or(SunDate{}), sun.hour));
  const double hour_rad = Radians(15.0 * (sun.hour - 12.0));
  const double phi = sun.latitude_rad, cosine = std::cos(declination_rad);
  const double sine = std::sin(declination_rad);
  return {std::cos(phi) * sine - std::sin(phi) * cosine * std::cos(hour_rad),
          cosine * std::sin(hour_rad),  // towards the west after noon
          std::sin(phi) * sine + std::cos(phi) * cosine * std::cos(hour_rad)};
}

}  // namespace

std::optional<SunDate> ParseSunDate(const std::string& text) {
  if (text.size() != 5 || text[2] != '-') return std::nullopt;
  for (const int i : {0, 1, 3, 4}) {
    if (!IsDigit(text[static_cast<std::size_t>(i)])) return std::nullopt;
  }
  const SunDate date{std::stoi(text.substr(0, 2)), std::stoi(text.substr(3, 2))};
  if (date.month < 1 || date.month > 12 || date.day < 1) return std::nullopt;
  if (date.day > kDaysBefore[date.month] - kDaysBefore[date.month - 1]) return std::nullopt;
  return date;
}

double DaysFrom2000(const SunDate& date, double hour) {
  return kDaysTo2013 + kDaysBefore[date.month - 1] + (date.day - 1) + hour / 24.0;
}

double SunDeclination_rad(double days) {
  const double t = days / 36525.0;  // Julian centuries
  const double mean_longitude = Radians(280.46646 + 36000.76983 * t);
  const double anomaly = Radians(357.52911 + 35999.05029 * t);
  const double centre =
      Radians((1.914602 - 0.004817 * t) * std::sin(anomaly) + 0.019993 * std::sin(2.0 * anomaly) +
              0.000289 * std::sin(3.0 * anomaly));
  // Aberration, and nutation by the Moon's node.
  const double node = Radians(125.04 - 1934.136 * t);
  const double longitude =
      mean_longitude + centre - Radians(0.00569) - Radians(0.00478) * std::sin(node);
  const double obliquity = Radians(23.439291 - 0.0130042 * t + 0.00256 * std::cos(node));
  return std::asin(std::sin(obliquity) * std::sin(longitude));
}

bool HasADate(const SunModel& sun) { return !sun.date.empty() && !std::isnan(sun.hour); }

double DatedElevation_rad(const SunModel& sun) { return std::asin(ToSunFromNorth(sun).z()); }

SunModel PlacedByDate(SunModel sun) {
  if (!HasADate(sun)) return sun;
  const Eigen::Vector3d to_sun = ToSunFromNorth(sun);
  sun.elevation_rad = std::asin(to_sun.z());
  sun.azimuth_rad = std::remainder(sun.north_rad + std::atan2(to_sun.y(), to_sun.x()), 2.0 * kPi);
  return sun;
}

}  // namespace dockyard
