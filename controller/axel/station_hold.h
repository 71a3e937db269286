// The pull that the station bears before it slides on its soles.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"

namespace dockyard::axel {

/// The pull, in any direction, that the station bears on a slope with the least friction and mass
/// that its tolerances allow [N], >= 0: mu m g cos(slope) - m g sin(slope).
double SureHold(const Nominal& nominal, const HoldOptions& options, double slope_rad);

/// The slope as the sightings teach it, or as the axle rolls: the steeper of the two.
double KnownSlope(const Senses& senses);

/// The tension that holds a seated rover in the socket [N]: more where its weight draws it out.
double SeatTension(const AxelOptions& options, const Senses& senses);

/// The most that the spool may be set to: the peaks of the tension stay below the sure hold [N].
double SurePull(const Nominal& nominal, const HoldOptions& options, const Senses& senses);

}  // namespace dockyard::axel
