#include "sim/scenario/sun_path.h"

#include <Eigen/Geometry>
#include <cmath>

namespace dockyard {
namespace {

// A mean solar day, and the obliquity of the ecliptic (Astronomical Almanac), rounded up.
constexpr double kDay_s = 86400.0, kObliquity_rad = Radians(23.45);

}  // namespace

Eigen::Vector3d DirectionOf(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad),
          std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

Eigen::Vector3d NorthPole(const SunModel& sun, const Eigen::Vector3d& to_sun_L) {
  const double below_sun_rad = std::atan2(to_sun_L.y(), to_sun_L.x());
  const double noon_rad = sun.latitude_rad < 0.0 ? below_sun_rad : below_sun_rad + kPi;
  return DirectionOf(std::isnan(sun.north_rad) ? noon_rad : sun.north_rad, sun.latitude_rad);
}

Eigen::Vector3d SunAfter(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& to_pole,
                         double seconds) {
  const double turn_rad = -2.0 * kPi * seconds / kDay_s;
  return (Eigen::AngleAxisd(turn_rad, to_pole) * to_sun).normalized();
}

bool HasASeason(const SunModel& sun) {
  if (!sun.moving || std::isnan(sun.elevation_rad)) return true;
  const double azimuth_rad = std::isnan(sun.azimuth_rad) ? 0.0 : sun.azimuth_rad;
  const Eigen::Vector3d to_sun_L = DirectionOf(azimuth_rad, sun.elevation_rad);
  return std::abs(NorthPole(sun, to_sun_L).dot(to_sun_L)) <= std::sin(kObliquity_rad);
}

}  // namespace dockyard
