// The pull that the station bears before it slides or turns on its soles.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"

namespace dockyard::axel {

/// The pull at the mouth that the station bears on a slope in any direction, with the
/// least friction and mass that its tolerances allow [N], >= 0. A pull from aside turns the station
/// as well: the soles hold force F and moment M about their middle while (F/F0)^2 + (M/M0)^2 <= 1
/// (ellipsoidal limit surface; Howe and Cutkosky, Int. J. Robotics Research 15, 1996).
/// @param aside_rad  of the pull, against the station's axis
double SureHold(const Nominal& nominal, const HoldOptions& options, double slope_rad,
                double aside_rad);

/// The slope as the sightings teach it, or as the axle rolls: the steeper of the two.
double KnownSlope(const Senses& senses);

/// The tension that holds a seated rover in the socket [N]: more where its weight draws it out.
double SeatTension(const AxelOptions& options, const Senses& senses);

/// The set point of a spool whose tension stays below that [N].
double SetPointBelow(double tension_n, const HoldOptions& options);

/// The most that the spool may be set to: the peaks of the tension stay below the sure hold [N].
double SurePull(const Nominal& nominal, const HoldOptions& options, const Senses& senses);

/// The tension that keeps the tether taut [N]: as on a leg, or the sure pull, if that is less.
/// Before the first sighting nothing tells from where the tether pulls: then the least.
double TautTension(const Nominal& nominal, const AxelOptions& options, const Senses& senses);

}  // namespace dockyard::axel
