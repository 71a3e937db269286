// Gravity on Earth, in which the soils were measured and the rover docks.
#pragma once

namespace dockyard {

/// Standard gravity, rounded; in Pasadena, where the Mars Yard is, 9.796 m/s^2.
inline constexpr double kEarthGravity_m_s2 = 9.81;

}  // namespace dockyard
