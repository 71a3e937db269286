// Small gaps of a map of heights closed by straight lines.
#pragma once

#include "controller/stereo/elevation.h"

namespace dockyard {

/// Gaps of at most `most_cells` cells between known ones, along a row or a column, get the heights
/// of the straight line across; where both close, the mean of the two. Their sigmas follow from
/// those at the ends, with a tenth of the step between these. Their `points` stay 0. Larger gaps
/// stay: behind a stone nothing was seen.
void FillGaps(int most_cells, ElevationMap& map);

}  // namespace dockyard
