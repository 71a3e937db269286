// Rounded rocks on which an operator would place an instrument: it can rest on the target, and the
// mast reaches the surface's normal there.
#pragma once

#include <cstdint>
#include <optional>

#include "models/parts/rover_model.h"
#include "sim/vehicles/rounded_rock.h"

namespace dockyard::rocky7 {

/// How far the surface falls away under the circle of contact switches that rests on it there, in
/// the mean [m]; none where the surface has no normal, or ends under the circle.
std::optional<double> FallUnderSwitches(const StarBody& rock, const InstrumentModel& instrument,
                                        const Eigen::Vector3d& p, const Eigen::Vector3d& normal);

/// Whether the tool meets the target along the inward normal with the rover on the ground that the
/// rock lies on, pitched a little up or down, its front wheels clear of the rock's foot.
bool MastMeets(const StarBody& rock, const RoverModel& rover, const Eigen::Vector3d& target,
               const Eigen::Vector3d& normal);

/// The first rock of those that the key draws where both hold; with a click's error about the
/// target the instrument still rests on it. None: no such rock in many draws.
std::optional<StarBody> PlaceableRock(const RoundedRockShape& shape, const RoverModel& rover,
                                      std::uint64_t key);

}  // namespace dockyard::rocky7
