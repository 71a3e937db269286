// The way out of a rover that starts seated: what the spool pulls with, and how far it is.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"

namespace dockyard::axel {

/// How the ground falls from the station along the cone's axis [rad], by the elevation against the
/// level of an arm in the socket, which lies along it.
double FallBySeatedArm(const Nominal& nominal, double elevation_rad);

/// Tension of the spool that pays out on ground that falls by this much away from the station [N].
/// On ground that rises it is that of any reverse.
double OutwardTension(const AxelOptions& options, double fall_rad);

/// Way from the seat until the tip is clear of the mouth [m].
double UndockedWay(const Nominal& nominal, const ExcursionOptions& options);

/// Way out [m] of a rover whose spool paid out and whose wheels rolled back by these. Wheels slip
/// and a slack tether is longer than the way, so that the lesser counts.
double WayOut(double paid_out_m, double rolled_back_m);

/// Nominal way of a return by dead reckoning [m]; 0: the board is near enough as it is.
double WayBack(double way_out_m, const ExcursionOptions& options);

}  // namespace dockyard::axel
