// How near the rover is to tipping over with its arm or its mast out.
#pragma once

#include "controller/io/sensors.h"
#include "controller/rocky7/mast.h"

namespace dockyard::rocky7 {

/// With less the rover does not reach out. It covers the errors of its masses and its attitude, and
/// wheels that sink. Assumed, 2-5 cm.
inline constexpr double kLeastTippingMargin_m = 0.03;

/// Least distance [m], within the plane of the wheels' contacts, from where the weight's line of
/// action meets it to the sides of the wheels' polygon; < 0: it tips. The rover is at rest;
/// infinite where its masses are not known.
/// @param arm   roll and pitch of its shoulder
/// @param mast  its joints
double TippingMargin(const Nominal& nominal, const ImuSample& attitude,
                     const std::array<double, 2>& arm, const MastAngles& mast);

}  // namespace dockyard::rocky7
