// What a fit must have to be the pyramid, or its guide, and not other things of like colours.
#pragma once

#include "controller/raposa/pyramid_fit.h"

namespace dockyard::raposa {

/// Whether the pyramid is believed to be where the fit has it: then less is asked.
enum class Expected { kAnywhere, kThere };

bool IsPyramid(const PlaceFit& fit, const PlacePrior& prior, Expected expected);

/// @param off_ground_chi2  OffTheGround of the fit
/// @param clipped          the view's edge cuts it
bool IsGuide(const PlaceFit& fit, double off_ground_chi2, bool clipped);

/// How far height, pitch and roll are from what prior expects of a guide on the ground that the
/// robot is on: sum of squares by the sigmas.
double OffTheGround(const PyramidPlace& place, const PlacePrior& prior);

/// The camera's place about the guide, counter-clockwise from the guide's axis.
double AlphaOf(const Pose2& X_VD);

}  // namespace dockyard::raposa
