// What an eye found in a picture, for the log and for people. Nothing acts on it.
#pragma once

#include "controller/io/belief.h"
#include "controller/raposa/marks.h"
#include "controller/raposa/pyramid_finder.h"

namespace dockyard::raposa {

/// Mark 0 is the guide. With a pose, 1 and on are the middles of the square's strips, where the
/// pose has them; X_RB is D in R, and its covariance that of x, y and the turn about z.
/// @param X_DN  by the first fit, now; N: R turned half round. Not used without a fit
SightingReport ReportOf(const PyramidSighting& sighting, const Pose2& X_DN, const Nominal& nominal);

/// Mark 0 is the ellipse, 1 the middle of the blue's bounding region.
/// @param X_DN  by the pair. Not used without one
SightingReport ReportOf(const MarksSeen& seen, const Pose2& X_DN);

}  // namespace dockyard::raposa
