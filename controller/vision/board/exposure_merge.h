// One picture out of several of the same sight, taken at a standstill with different exposures.
#pragma once

#include <vector>

#include "controller/geometry/image.h"

namespace dockyard {

/// A picture and the stops by which its exposure was off the cameras' own: a pixel's number grows
/// with the light times 2^stops until it saturates (linear sensor, no gamma).
struct ExposedImage {
  GrayImage image;
  double stops = 0.0;
};

/// What the weights know of a sensor. All in pixel numbers (0 to 255) of the single picture.
struct ExposureMergeOptions {
  // Numbers from here on may be saturated: full trust up to the first, none from the second. A
  // blurred edge of a saturated area is brighter than it shows. Assumed, 225-245 and 248-254.
  double trusted = 235.0, saturated = 250.0;
  // Variance of a number z: read noise and rounding, and shot noise in proportion to z. 15
  // electrons of 20 000 are 0.19 and rounding is 1/sqrt(12), together 0.12; a number is 78
  // electrons, so shot noise is z/78. Assumed, 0.08-1 and 0.005-0.05: only their ratio acts.
  double floor_variance = 0.12, shot_variance = 0.013;
  // Light that the most exposed picture shows with this number is where the curve turns from linear
  // to logarithmic: below it is noise. Assumed, 2-16.
  double knee = 8.0;
};

/// Radiance of each pixel, row by row, in numbers of a picture at 0 stops: the mean of z / 2^stops
/// with weights of inverse variance, falling to nothing at saturation (Debevec and Malik 1997, with
/// the weights of Granados et al. 2010 for a linear sensor). A pixel that every picture saturates
/// gets the bound that the least exposed one gives. Empty without pictures; pictures of another
/// size than the first are left out.
std::vector<float> MergedRadiance(const std::vector<ExposedImage>& pictures,
                                  const ExposureMergeOptions& options = {});

/// The merged radiance E as 8 bits, 255 log(1 + E/k) / log(1 + E_max/k): equal ratios of light are
/// equal steps, whether in sun or in shade. k is the knee's light, E_max the picture's brightest.
/// Without pictures an empty image.
GrayImage MergeExposures(const std::vector<ExposedImage>& pictures,
                         const ExposureMergeOptions& options = {});

}  // namespace dockyard
