// How the arm fits the socket, by geometry alone and on level ground: for the mouth's height, the
// limits of the judge and the warnings of `check`. docs/reference/physics.md#how-the-arm-mates
#pragma once

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"

namespace dockyard::axel {

/// Depth at which an arm is seated [m]: that of the socket's floor; in a socket without one the 25
/// cm that are reeled in (Tsai et al., II).
double SeatDepth(const ConeModel& cone);

/// Angle by which the seated arm can turn either way before disc and collar touch the socket on
/// opposite sides [rad]; without a collar, disc and shaft.
double SeatedPlay(const RoverModel& rover, const ConeModel& cone);

/// Height of the axle above the ground [m], in the middle between what a rover of 40 kg has on
/// loose sand and on compact gravel. The paddles sink into the one and carry on the other.
double MeanAxleHeight(const RoverModel& rover);

/// Height of the mouth's centre above the ground at which an axle axle_m high holds a seated arm
/// along the socket's axis [m].
double FittingMouthHeight(const RoverModel& rover, double axle_m, const ConeModel& cone,
                          double tip_angle_rad);

/// Elevation of the seated arm against the socket's axis [rad], positive when the arm is steeper,
/// with the tip on the axis and the axle axle_m above the ground.
double SeatedElevation(const RoverModel& rover, double axle_m, const StationModel& station);

}  // namespace dockyard::axel
