// Files of heights: PNG of 8 or 16 bits, TIFF, ESRI ASCII grid.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"
#include "sim/soil/height_map.h"

namespace dockyard {

/// The map of heights.file, which is named. Throws ConfigError for a file of another kind, without
/// a distance of its samples where the keys have none, and of more than 16 million samples.
HeightMap LoadHeights(const YardHeights& heights);

}  // namespace dockyard
