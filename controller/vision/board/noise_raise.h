// Internal to the vision room. For users' boards and cameras: the noise of the marks is what their
// residuals show, where that is more than predicted.
#pragma once

#include <optional>

#include "controller/vision/board/fix_fit.h"
#include "controller/vision/board/locate.h"

namespace dockyard {

/// Largest RMS error of an accepted pose [px]: 1 px (assumed, 0.7-2), less when few marks leave few
/// degrees of freedom. Five marks of one image must fit as well as predicted, since a wrong match
/// of them fits within G = 2.5 px (the gate of a match) by accident, and within r only in
/// (r/G)^4 of these cases: one power for each degree of freedom. More marks may err by an r that
/// makes this chance no larger.
double MostRaisedRmsPx(int freedom);

struct RaisedFix {
  Fix fix;
  std::optional<PoseFailure> failure{};  // the misfit's; the other gates are still to come
};

/// All sigmas of the marks are multiplied by one factor, never below one. The median of all
/// errors gives it first, so that a few wrong marks do not widen it, and marks beyond 4.5 of these
/// sigmas are left out. The errors of those that stay then give the factor of the fit.
///
/// A bow of the board or an error of the lens is a smooth shape: neighbouring marks err alike. So
/// the covariance takes what exceeds the prediction as if only six marks had shown it.
///
/// Refused are: an RMS error above MostRaisedRmsPx; marks that contradict the rest and are too many
/// to be left out; two images that each fit three times better than both together, above 0.5 px.
/// @param inputs  `refine.noise_scale` 1
RaisedFix WithNoiseRaised(FitInputs inputs, const Fix& fix);

}  // namespace dockyard
