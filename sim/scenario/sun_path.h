// The sun's path over the sky. Frame L: level, z up, its x axis where a scenario's azimuths begin;
// they count counter-clockwise from above.
#pragma once

#include <Eigen/Core>

#include "sim/scenario/scenario.h"

namespace dockyard {

/// A unit vector to what has this azimuth and this elevation over the level.
Eigen::Vector3d DirectionOf(double azimuth_rad, double elevation_rad);

/// A unit vector to the celestial north pole, about which the sky turns. to_sun_L: at the start. By
/// the model's north; without one the sun is in the meridian at the start: due south, and due north
/// at a southern latitude.
Eigen::Vector3d NorthPole(const SunModel& sun, const Eigen::Vector3d& to_sun_L);

/// The direction to the sun after that time: it turns about the pole, from east to west, by a turn
/// in a mean solar day. In the frame of both directions.
Eigen::Vector3d SunAfter(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& to_pole,
                         double seconds);

/// Whether some season has this sun, as far as the model states it: a declination within the
/// Earth's obliquity. True of one that does not move, and of one whose elevation is drawn.
bool HasASeason(const SunModel& sun);

}  // namespace dockyard
