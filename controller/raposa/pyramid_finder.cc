#include "controller/raposa/pyramid_finder.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "controller/raposa/mark_criteria.h"
#include "controller/raposa/spot_fit.h"

namespace dockyard::raposa {
namespace {

constexpr std::size_t kMostSpots = 5;  // orange regions that are looked into
// What calibration and lens leave of a direction. Assumed, 0.1-0.5 px of 377.
constexpr double kBearingFloor = 5e-4;
// What the marks' model leaves of a range, as a share: at least, and for each unit of misfit
// above 1. The scale that all ranges share is the filter's. Assumed, 0.3-1 % and 1-4 %.
constexpr double kRangeFloor = 0.005, kMisfitRange = 0.02;
// Of a pose whose guide the hole's rim cuts, as a share: on the way in it was up to 15 % too far.
// Assumed, 0.04-0.1.
constexpr double kClippedRange = 0.06;
// Of the range by the guide alone, as a share: its shading looks like size. From
// raposa_eye_survey; 0.04-0.1.
constexpr double kAloneRange = 0.06;
constexpr double kGate = 5.0;  // sigmas of the prior; assumed, 4-6
// A prior with a wider heading may have its angle in another valley of the fit. Assumed, 10-20 deg.
constexpr double kWideHeading = Radians(14.0);

GuideSighting SeenOf(const Nominal& nominal, const SpotFit& spot) {
  const PyramidPlace& place = spot.guide.place;
  const Eigen::Vector2d p(place.X_VD.x, place.X_VD.y);
  const double r_m = p.norm();
  GuideSighting sighting;
  sighting.range_m = r_m;
  sighting.bearing_rad = std::atan2(p.y(), p.x());
  const Eigen::Vector3d p_C = CameraToPyramid(place).p;
  sighting.down_rad = std::atan2(p_C.y(), p_C.z());
  sighting.centre_px = nominal.camera.Project(p_C).value_or(Eigen::Vector2d::Zero());
  const Eigen::Matrix2d covariance = spot.guide.covariance.topLeftCorner<2, 2>();
  const Eigen::Vector2d along = p / r_m, across(-along.y(), along.x());
  sighting.range_sigma_m = std::hypot(std::sqrt(along.dot(covariance * along)),
                                      spot.poses.empty() ? kAloneRange * r_m : 0.0);
  sighting.bearing_sigma_rad =
      std::hypot(std::sqrt(across.dot(covariance * across)) / r_m, kBearingFloor);
  sighting.clipped = spot.clipped;
  sighting.without_square = spot.without_square;
  if (spot.likely_alpha_rad) sighting.likely_side = *spot.likely_alpha_rad < 0.0 ? -1.0 : 1.0;
  return sighting;
}

PyramidFit FitOf(const PlaceFit& fit, bool clipped) {
  PyramidFit out{fit.place.X_VD,      fit.covariance.topLeftCorner<3, 3>(),
                 fit.misfit,          fit.place.down_m,
                 fit.place.pitch_rad, fit.place.roll_rad};
  const Pose2& X = fit.place.X_VD;
  const Eigen::Vector2d along(X.x, X.y), across(-X.y, X.x);
  const double floor = kRangeFloor + kMisfitRange * std::max(0.0, fit.misfit - 1.0) +
                       (clipped ? kClippedRange : 0.0);
  out.covariance.topLeftCorner<2, 2>() +=
      floor * floor * along * along.transpose() +
      kBearingFloor * kBearingFloor * across * across.transpose();
  return out;
}

/// Whether a guide in that direction and of that size can be the believed one.
bool Allowed(const Nominal& nominal, const OrangeSpot& spot, const PyramidPrior& prior) {
  const Eigen::Vector2d p(prior.X_VD.x, prior.X_VD.y);
  const double r_m = std::max(p.norm(), 0.05);
  const Eigen::Vector2d along = p / r_m, across(-along.y(), along.x());
  const Eigen::Matrix2d covariance = prior.covariance.topLeftCorner<2, 2>();
  const double bearing = std::atan2(p.y(), p.x());
  const Eigen::Vector3d d_C = nominal.camera.Direction(spot.centre_px);
  const double spot_rad = std::atan2(-d_C.x(), d_C.z());
  const double sigma = std::sqrt(across.dot(covariance * across)) / r_m;
  // A clipped or half-hidden guide's middle is off by up to its radius.
  const double radius = nominal.marks.guide_length_m / r_m;
  if (std::abs(WrapPi(spot_rad - bearing)) > kGate * sigma + 0.01 + radius) return false;
  if (spot.clipped) return true;
  const double range_m = RangeOfArea(nominal, spot.area_px2);
  const double range_sigma = std::sqrt(along.dot(covariance * along));
  return std::abs(range_m - r_m) < kGate * range_sigma + 0.35 * std::max(range_m, r_m);
}

double Distance2(const PlaceFit& fit, const PyramidPrior& prior) {
  const Pose2& X = fit.place.X_VD;
  const Eigen::Vector3d off(X.x - prior.X_VD.x, X.y - prior.X_VD.y,
                            WrapPi(X.heading - prior.X_VD.heading));
  const Eigen::Matrix3d both = prior.covariance + fit.covariance.topLeftCorner<3, 3>();
  return off.dot(both.llt().solve(off));
}

/// Fits that the prior rules out go. The guide stays: its place was allowed.
void Gate(const PyramidPrior& prior, SpotFit* spot) {
  std::erase_if(spot->poses,
                [&](const PlaceFit& fit) { return Distance2(fit, prior) > kGate * kGate; });
  if (!spot->poses.empty()) spot->guide = spot->poses.front();
}

/// A pair is better than a guide alone, one that may have a square better than one that has none,
/// then the clearer one.
bool Better(const SpotFit& a, const SpotFit& b) {
  if (a.poses.empty() != b.poses.empty()) return !a.poses.empty();
  if (!a.poses.empty()) return a.poses.front().misfit < b.poses.front().misfit;
  if (a.without_square.all() != b.without_square.all()) return b.without_square.all();
  return a.guide.misfit + a.off_ground_chi2 < b.guide.misfit + b.off_ground_chi2;
}

/// The refuted thing that the spot shows; none: another.
std::optional<PyramidSighting::Known> KnownThing(const Nominal& nominal, const OrangeSpot& spot,
                                                 const std::vector<RefutedThing>& refuted) {
  const Eigen::Vector3d d_C = nominal.camera.Direction(spot.centre_px);
  const double bearing_rad = std::atan2(-d_C.x(), d_C.z());
  for (std::size_t i = 0; i < refuted.size(); ++i) {
    if (Is(refuted[i], bearing_rad, RangeOfArea(nominal, spot.area_px2))) return {{i, bearing_rad}};
  }
  return std::nullopt;
}

/// Where prior expects the guide, for one that is one region with a thing behind it. None where it
/// would be out of view.
std::optional<OrangeSpot> ExpectedSpot(const Nominal& nominal, const TintMap& map, double pitch_rad,
                                       const PyramidPrior& prior) {
  const auto marks = ProjectGuide(nominal, {prior.X_VD, NominalDown(nominal), pitch_rad, 0.0});
  if (!marks || !marks->guide_px) return std::nullopt;
  OrangeSpot spot;
  spot.centre_px = *marks->guide_px;
  const double r_m = std::hypot(prior.X_VD.x, prior.X_VD.y);
  const double radius_px =
      0.5 * nominal.marks.guide_diameter_m * nominal.camera.focal_px().x() / r_m;
  if ((spot.centre_px - map.middle_px).norm() + radius_px > map.hole_px) return std::nullopt;
  spot.area_px2 = kPi * radius_px * radius_px;
  spot.left = static_cast<int>(0.5 * (spot.centre_px.x() - radius_px));
  spot.right = static_cast<int>(0.5 * (spot.centre_px.x() + radius_px));
  spot.top = static_cast<int>(spot.centre_px.y() - radius_px);
  spot.bottom = static_cast<int>(spot.centre_px.y() + radius_px);
  return spot;
}

}  // namespace

PyramidFinder::PyramidFinder(const Nominal& nominal) : nominal_(nominal) {}

namespace {

std::optional<SpotFit> BestOf(const Nominal& nominal, const TintMap& map, double pitch_rad,
                              const std::optional<PyramidPrior>& prior,
                              const std::vector<RefutedThing>& refuted,
                              std::vector<PyramidSighting::Known>* known) {
  std::optional<SpotFit> best;
  for (const OrangeSpot& spot : OrangeSpots(map, kMostSpots)) {
    const bool expected = prior && Allowed(nominal, spot, *prior);
    if (const auto thing = expected ? std::nullopt : KnownThing(nominal, spot, refuted)) {
      if (!spot.clipped) known->push_back(*thing);
      continue;
    }
    std::optional<SpotFit> fit;
    if (prior) {
      if (!expected) continue;
      fit = FitSpot(nominal, map, spot, pitch_rad, prior->X_VD);
    }
    const bool open = !prior || prior->covariance(2, 2) > kWideHeading * kWideHeading;
    if (open && (!fit || fit->poses.empty())) {
      fit = FitSpot(nominal, map, spot, pitch_rad, std::nullopt);
    }
    if (!fit) continue;
    if (prior) Gate(*prior, &*fit);
    // The believed guide shows its square where it can.
    if (!open && fit->poses.empty() && fit->without_square[AngleIndex(AlphaOf(prior->X_VD))]) {
      continue;
    }
    if (map.spots == Spots::kFaint && fit->poses.empty()) continue;
    if (!best || Better(*fit, *best)) best = fit;
  }
  if (!prior || (best && !best->poses.empty()) || map.spots == Spots::kFaint) return best;
  const auto expected = ExpectedSpot(nominal, map, pitch_rad, *prior);
  if (!expected) return best;
  std::optional<SpotFit> fit = FitSpot(nominal, map, *expected, pitch_rad, prior->X_VD);
  if (!fit) return best;
  Gate(*prior, &*fit);
  return fit->poses.empty() ? best : fit;
}

}  // namespace

PyramidSighting PyramidFinder::Find(const RgbImage& image, double pitch_rad,
                                    const std::optional<PyramidPrior>& prior,
                                    const std::vector<RefutedThing>& refuted) const {
  PyramidSighting sighting;
  const auto best_of = [&](const TintMap& map) {
    sighting.known.clear();
    return BestOf(nominal_, map, pitch_rad, prior, refuted, &sighting.known);
  };
  std::optional<SpotFit> best = best_of(TintsOf(image, nominal_));
  if (!best) best = best_of(TintsOf(image, nominal_, Spots::kFaint));
  if (!best) return sighting;
  sighting.guide = SeenOf(nominal_, *best);
  for (const PlaceFit& fit : best->poses) sighting.fits.push_back(FitOf(fit, best->clipped));
  return sighting;
}

}  // namespace dockyard::raposa
