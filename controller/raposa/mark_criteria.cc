#include "controller/raposa/mark_criteria.h"

#include <cmath>

namespace dockyard::raposa {
namespace {

// |blue| over |orange| in the values of FitWindow: the paints of render/spectrum.cc in light of
// 3000 to 6500 K, camera balanced for 5000 K: 0.18-0.63; five times that where one lies in shade.
// Of true poses 98 of 100 have more than 0.16, a quarter of the false ones less: assumed, 0.12-0.2.
constexpr double kLeastBlueShare = 0.036, kLeastFreeBlueShare = 0.16, kMostBlueShare = 3.0;
// A fit with more is none; without a place where the pyramid is believed, other things of like
// colours are more likely than shadows. From raposa_eye_survey: 97 of 100 true poses have less than
// 2.4, 99 of 100 true guides less than 5.4. Assumed, 2.5-4, 2-3 and 5-7.
constexpr double kMostMisfit = 3.0, kMostFreeMisfit = 2.4, kMostGuideMisfit = 5.5;
// Marks that go on beyond their edges, or are of two colours, are others. From the same survey: 92
// of 100 true poses hold all four; of false ones half have more than 0.4 beyond the blue.
// Assumed, 0.03-0.1, 0.1-0.3, 0.05-0.15 and 0.08-0.15. Where the pyramid is believed a thing of its
// colour may be behind half of the guide: 0.3-0.6, 0.15-0.3, 0.2-0.4 and 0.2-0.3. A guide
// alone has 0.05-0.1 and 0.2-0.3.
struct Limits {
  double misfit;
  MarkBorder orange, blue;
  double least_blue_share;
};
constexpr Limits kFree{kMostFreeMisfit, {0.05, 0.08}, {0.15, 0.12}, kLeastFreeBlueShare};
constexpr Limits kBelieved{kMostMisfit, {0.50, 0.20}, {0.30, 0.24}, kLeastBlueShare};
constexpr MarkBorder kMostAlone{0.06, 0.25};
// Blue must stand out of the noise, and cover so much. Assumed, 5-10 and 2-6.
constexpr double kLeastBlueSigmas = 6.0, kLeastBlue_px2 = 2.0, kLeastOrangeSigmas = 7.0;
// The second value of orange over its first, the first of blue over its second: from
// raposa_eye_survey, -0.7 to 0 and -0.9 to 0.3. Assumed, that widened by 0.15-0.4.
constexpr double kLeastOrangeHue = -1.0, kMostOrangeHue = 0.2;
constexpr double kLeastBlueHue = -1.2, kMostBlueHue = 0.5;
// Of orange in the values of FitWindow; from the same survey, 0.36 at least. Assumed, 0.2-0.35.
constexpr double kLeastOrange = 0.25;
// Of pitch, roll and height from their nominal values: one in 100 of 3 degrees of freedom; of pitch
// and height, one in 20. The middle of a clipped guide is not known: from raposa_eye_survey.
// Assumed, 9-12, 5-8, 20-40.
constexpr double kMostPriorChi2 = 11.3, kMostAloneChi2 = 6.0, kMostClippedChi2 = 30.0;
// The mission asks for 110 deg; a fit may be off. Assumed, 115-130 deg.
constexpr double kMostAlpha = Radians(122.0);
constexpr double kMostRange_m = 6.0;  // the marks are then a pixel or two; assumed, 5-7

bool Between(double low, double value, double high) { return low < value && value < high; }

bool Ends(const MarkBorder& border, const MarkBorder& most) {
  return border.beyond < most.beyond && border.others < most.others;
}

/// Whether two paints in one light can be those of the marks.
bool ColoursOfMarks(const Eigen::Vector2d& orange, const Eigen::Vector2d& blue,
                    double least_blue_share) {
  const double share = blue.norm() / orange.norm();
  return orange.x() > 0.0 && orange.norm() > kLeastOrange && blue.y() > 0.0 &&
         Between(least_blue_share, share, kMostBlueShare) &&
         Between(kLeastOrangeHue, orange.y() / orange.x(), kMostOrangeHue) &&
         Between(kLeastBlueHue, blue.x() / blue.y(), kMostBlueHue);
}

}  // namespace

double AlphaOf(const Pose2& X_VD) {
  const Pose2 X_DV = Inverse(X_VD);
  return std::atan2(X_DV.y, X_DV.x);
}

double OffTheGround(const PyramidPlace& place, const PlacePrior& prior) {
  const PlaceVector at = ToVector(place);
  double chi2 = 0.0;
  for (const Eigen::Index i : {3, 4, 5}) {
    if (prior.sigma[i] > 0.0) chi2 += std::pow((at[i] - prior.mean[i]) / prior.sigma[i], 2);
  }
  return chi2;
}

bool IsPyramid(const PlaceFit& fit, const PlacePrior& prior, Expected expected) {
  const Limits& limits = expected == Expected::kThere ? kBelieved : kFree;
  return fit.misfit < limits.misfit && Ends(fit.orange_border, limits.orange) &&
         Ends(fit.blue_border, limits.blue) &&
         ColoursOfMarks(fit.orange, fit.blue, limits.least_blue_share) &&
         OffTheGround(fit.place, prior) < kMostPriorChi2 && fit.blue_sigmas > kLeastBlueSigmas &&
         fit.orange_sigmas > kLeastOrangeSigmas && fit.blue_px2 > kLeastBlue_px2 &&
         std::abs(AlphaOf(fit.place.X_VD)) < kMostAlpha &&
         std::hypot(fit.place.X_VD.x, fit.place.X_VD.y) < kMostRange_m;
}

bool IsGuide(const PlaceFit& fit, double off_ground_chi2, bool clipped) {
  // In the light of the lamps alone the ground is blue, and orange has far less of it.
  return fit.orange.x() > 0.0 && fit.orange.y() < kMostOrangeHue * fit.orange.x() &&
         fit.orange_sigmas > kLeastOrangeSigmas && fit.misfit < kMostGuideMisfit &&
         Ends(fit.orange_border, kMostAlone) &&
         off_ground_chi2 < (clipped ? kMostClippedChi2 : kMostAloneChi2);
}

}  // namespace dockyard::raposa
