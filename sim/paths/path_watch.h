// A planned path as a run to watch: the rover drives it, its wheels steered and turning.
#pragma once

#include "sim/log/logged_run.h"
#include "sim/paths/planned_path.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// The run on level ground, by time: before each arc the wheels are steered at the rover's rate,
/// then it is driven at its speed. The task must have a rover with wheels, the plan a path.
LoggedRun WatchedPath(const PathTask& task, const PlannedPath& plan);

/// More discs are not shown: those nearest to the rover's start and to the goal are.
inline constexpr std::size_t kMostShownDiscs = 1000;

/// Its bodies, in the run's order: body, wheels, obstacles.
StageShapes ShapesOf(const PathTask& task);

/// Meanings of the run's scalars: each wheel's steering angle and speed.
std::vector<Column> WatchedChannels(const RoverPlan& rover);

}  // namespace dockyard
