// Images in a log that no sighting is about: those of a controller that reports none.
#pragma once

#include <cstddef>

#include "sim/log/logged_run.h"
#include "sim/page/payload.h"

namespace dockyard {

/// `images` of a replay; null where each image has its sighting.
/// @param most  so many image files are kept, evenly over the run; the begin and the end are among
///              them
Json ImagesPart(const LoggedRun& run, std::size_t most, Payload& payload);

}  // namespace dockyard
