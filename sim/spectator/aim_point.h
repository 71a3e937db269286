// The point that a spectator is aimed at.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/log/logged_run.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// A point by its name, or a place in the target's frame, z from its ground.
struct Aim {
  std::string name;
  std::optional<Eigen::Vector3d> p_D;
};

/// The names that an aim can have: `target`, `robot`, the system's points, the other bodies.
std::vector<std::string> AimNames(const StageShapes& shapes);

/// Where the point is at that sample. The name must be one of AimNames. Throws DataError for a log
/// that lacks the body.
Eigen::Vector3d AimPlace(const Aim& aim, const LoggedRun& run, const StageShapes& shapes,
                         std::size_t sample);

}  // namespace dockyard
