// Images in a log that no sighting is about: those of a controller that reports none.
#pragma once

#include <cstddef>

#include "sim/log/logged_run.h"
#include "sim/page/payload.h"

namespace dockyard {

/// `images` of a replay; null where each image has its sighting.
/// @param most  number of image files to keep, evenly over the run; the first and the last are
///              among them
Json ImagesPart(const LoggedRun& run, std::size_t most, Payload& payload);

}  // namespace dockyard
