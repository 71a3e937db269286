// Cameras' images as a report keeps them: small.
#pragma once

#include <string>
#include <vector>

#include "sim/log/logged_run.h"

namespace dockyard {

/// Each as a WebP at most 640 px wide; empty for null and for bytes that are no PNG of ours. They
/// are the same for any number of processors, all of which take part.
std::vector<std::string> SmallPictures(const std::vector<const LoggedImage*>& images);

}  // namespace dockyard
