// Rounded rocks on which an operator would place an instrument: the target is in view from the
// start, the instrument can rest on it, and the mast reaches the surface's normal there.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "models/rocky7/robot_model.h"
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

/// Whether both hold at the shape's target; with a click's error about it the instrument still
/// rests.
bool IsPlaceable(const StarBody& rock, const RoundedRockShape& shape, const RoverModel& rover);

/// The left camera of the mast's pair, in G, with the rover there in plan on level ground and the
/// mast as it watches.
Eigen::Vector3d MastCameraAtStart(const RobotModel& robot, const Pose2& X_GR);

/// Whether a camera at that point has the target in view: no other part of the rock hides it.
bool ShowsTarget(const StarBody& rock, const RoundedRockShape& shape, const Eigen::Vector3d& from);

/// The first rock of those that the key draws that is taken. None: no such rock in many draws.
std::optional<StarBody> FirstRock(const RoundedRockShape& shape, std::uint64_t key,
                                  const std::function<bool(const StarBody&)>& takes);

}  // namespace dockyard::rocky7
