// A view to the target of a run that can be watched, in a report.
#pragma once

#include "sim/log/logged_run.h"
#include "sim/page/payload.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// `near` of an entry of `replays`: where the target's point is over the run, in the site G, and
/// the vector from it to a camera that shows it from near (FindNearView). Null for a log without a
/// whole sample. Throws DataError for a log whose bodies are not those of the shapes.
Json NearPart(const LoggedRun& run, const StageShapes& shapes, Payload& payload);

}  // namespace dockyard
