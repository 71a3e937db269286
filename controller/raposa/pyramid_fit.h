// The pyramid's place from a window of the image: the least squares of what the marks, drawn there
// and blurred, leave of it. Levenberg and Marquardt's method; the layers' colours are found at each
// step, so no colour is known beforehand.
#pragma once

#include <optional>

#include "controller/raposa/layers.h"

namespace dockyard::raposa {

/// x, y, heading of X_VD, down, pitch, roll of PyramidPlace.
inline constexpr int kPlaceUnknowns = 6;
using PlaceVector = Eigen::Matrix<double, kPlaceUnknowns, 1>;
PlaceVector ToVector(const PyramidPlace& place);
PyramidPlace ToPlace(const PlaceVector& values);

/// What is known of the unknowns beforehand; a sigma of 0 holds the unknown.
struct PlacePrior {
  PlaceVector mean = PlaceVector::Zero();
  PlaceVector sigma = PlaceVector::Constant(1e3);
};

/// Of a mark (mark_borders.h): shares with its colour beyond its edges, and of other things within.
struct MarkBorder {
  double beyond = 0.0, others = 0.0;
};

struct PlaceFit {
  PyramidPlace place;
  Eigen::Matrix<double, kPlaceUnknowns, kPlaceUnknowns> covariance =
      Eigen::Matrix<double, kPlaceUnknowns, kPlaceUnknowns>::Zero();
  double chi2 = 0.0;
  // Mean square of what is left of the marks' cells, none of which counts above another thing.
  double misfit = 0.0;
  Eigen::Vector2d orange{0, 0}, blue{0, 0};       // the two values of FitWindow
  double orange_sigmas = 0.0, blue_sigmas = 0.0;  // of those from 0
  double blue_px2 = 0.0;                          // of it in the open part of the window
  MarkBorder orange_border, blue_border;
};

enum class MarksDrawn { kGuide, kAll };

/// chi2 of a place, as FitPlace's; none where the marks have no sound image. Cheap: weights of
/// colours that this place gives.
std::optional<double> CostOf(const Nominal& nominal, const FitWindow& window,
                             const PyramidPlace& place, const PlacePrior& prior, MarksDrawn drawn);

/// From a start near the place.
std::optional<PlaceFit> FitPlace(const Nominal& nominal, const FitWindow& window,
                                 const PyramidPlace& start, const PlacePrior& prior,
                                 MarksDrawn drawn, int most_steps);

}  // namespace dockyard::raposa
