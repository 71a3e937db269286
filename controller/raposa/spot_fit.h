// From an orange spot to the pyramid: is it the guide, and how does the pyramid lie?
#pragma once

#include <optional>
#include <vector>

#include "controller/raposa/pyramid_fit.h"
#include "controller/raposa/square_sought.h"

namespace dockyard::raposa {

/// A spot, explained.
struct SpotFit {
  PlaceFit guide;                // by the best that is known of it
  std::vector<PlaceFit> poses;   // of the whole pyramid; the better one first
  bool clipped = false;          // the guide reaches the hole's rim
  Angles without_square;         // of a guide alone; no blue where the square would be in view
  double off_ground_chi2 = 0.0;  // of a guide alone (mark_criteria.h)
  // Without a pose: by which angle the pyramid explains the picture best. Only its sign is told.
  std::optional<double> likely_alpha_rad;
};

/// @param pitch_rad  of the camera, down
/// @param start      where the pyramid is believed to be; else all angles are tried
std::optional<SpotFit> FitSpot(const Nominal& nominal, const TintMap& map, const OrangeSpot& spot,
                               double pitch_rad, const std::optional<Pose2>& start);

/// Distance at which the guide covers so much of the image.
double RangeOfArea(const Nominal& nominal, double area_px2);
/// From the camera's height above the belts' ground to the guide's.
double NominalDown(const Nominal& nominal);

}  // namespace dockyard::raposa
