#include "controller/raposa/spot_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "controller/raposa/mark_criteria.h"

namespace dockyard::raposa {
namespace {

constexpr double kPitchSigma = Radians(2.0);  // of the camera against its told pitch; assumed, 1-3
constexpr double kRollSigma = Radians(1.5);   // ground under robot and pyramid; assumed, 1-3 deg
constexpr double kDownSigma_m = 0.008;        // of the camera's height; assumed, 5-15 mm
constexpr double kGroundSlopeSigma = Radians(0.8);  // from robot to pyramid; assumed, 0.5-2 deg
// Of a window, at most. From kFine_m on the strips are 4 px wide and less: cells of 4 px would hide
// their edges, and angles at 2.5-4 m be off by 4.2 instead of 1.5 deg (docs/raposa.md). Assumed,
// 1.2-2 m.
constexpr int kGridCells = 250, kFitCells = 1000, kFineFitCells = 2000;
constexpr double kFine_m = 1.6;
// Of a window about the marks, at kLimitsFocal_px. Assumed, 5-10.
constexpr double kMargin_px = 7.0;
// Of the range by a spot's area, as a share. Assumed, 0.2-0.4.
constexpr double kAreaRangeSigma = 0.3;
// A fit with more misfit may have its square in another valley: too small, its paint counts as
// another thing. It is tried from these shares of its range, too. One with far more is of another
// thing. Assumed, 0.5-1.2, 4-6, 0.75-0.95, 1.05-1.25.
constexpr double kPoorMisfit = 0.65, kHopelessMisfit = 5.0;
constexpr std::array<double, 3> kOtherRanges{0.8, 0.9, 1.1};
// Of a second pose's chi2 above the best one's, by the misfit: three sigmas.
constexpr double kRivalChi2 = 9.0;

/// Bearing to the left and angle below the level of a pixel, for a camera of that pitch.
struct Sightline {
  double bearing_rad = 0.0, down_rad = 0.0;
};
Sightline SightlineOf(const Nominal& nominal, const Eigen::Vector2d& pixel, double pitch_rad) {
  const Pose3 X_CV0 = CameraToPyramid({{}, 0.0, pitch_rad, 0.0});
  const Eigen::Vector3d d_V = X_CV0.R.transpose() * nominal.camera.Direction(pixel);
  return {std::atan2(d_V.y(), d_V.x()), std::atan2(-d_V.z(), std::hypot(d_V.x(), d_V.y()))};
}

/// With the guide's middle at the pixel, by the camera's pitch.
PyramidPlace PlaceAt(const Nominal& nominal, const Eigen::Vector2d& pixel, double pitch_rad,
                     double r_m, double alpha_rad) {
  const Sightline line = SightlineOf(nominal, pixel, pitch_rad);
  PyramidPlace place;
  place.X_VD = {r_m * std::cos(line.bearing_rad), r_m * std::sin(line.bearing_rad),
                WrapPi(line.bearing_rad + kPi - alpha_rad)};
  place.down_m = NominalDown(nominal);
  place.pitch_rad = pitch_rad + std::atan(place.down_m / r_m) - line.down_rad;
  return place;
}

PlacePrior PriorFor(const Nominal& nominal, double pitch_rad, double r_m) {
  PlacePrior prior;
  prior.mean[3] = NominalDown(nominal);
  prior.sigma[3] = std::hypot(kDownSigma_m, kGroundSlopeSigma * r_m);
  prior.mean[4] = pitch_rad;
  prior.sigma[4] = kPitchSigma;
  prior.sigma[5] = kRollSigma;
  return prior;
}

/// A guide alone tells no roll, and nothing of where its axis leads.
PlacePrior AlonePrior(const Nominal& nominal, double pitch_rad, double r_m) {
  PlacePrior prior = PriorFor(nominal, pitch_rad, r_m);
  prior.sigma[2] = prior.sigma[5] = 0.0;
  return prior;
}

void Widen(const ConvexPolygon& polygon, PixelRect* rect) {
  for (int i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d& p = polygon.corners[static_cast<std::size_t>(i)];
    rect->left = std::min(rect->left, p.x());
    rect->right = std::max(rect->right, p.x());
    rect->top = std::min(rect->top, p.y());
    rect->bottom = std::max(rect->bottom, p.y());
  }
}

/// About all marks of the places, within what the hole leaves.
PixelRect RectOf(const Nominal& nominal, const TintMap& map,
                 const std::vector<PyramidPlace>& places, MarksDrawn drawn) {
  PixelRect rect{1e9, 1e9, -1e9, -1e9};
  for (const PyramidPlace& place : places) {
    const auto marks =
        drawn == MarksDrawn::kAll ? ProjectMarks(nominal, place) : ProjectGuide(nominal, place);
    if (!marks) continue;
    Widen(marks->guide, &rect);
    for (const ConvexPolygon& strip : marks->strips) Widen(strip, &rect);
    for (const ConvexPolygon& box : marks->boxes) Widen(box, &rect);
  }
  const Eigen::Vector2d c = map.middle_px;
  return {std::max(rect.left - kMargin_px * map.finer, c.x() - map.hole_px),
          std::max(rect.top - kMargin_px * map.finer, c.y() - map.hole_px),
          std::min(rect.right + kMargin_px * map.finer, c.x() + map.hole_px),
          std::min(rect.bottom + kMargin_px * map.finer, c.y() + map.hole_px)};
}

/// The lowest row at which a horizon may be: above the square.
double LowestHorizon(const Nominal& nominal, double guide_row_px, double r_m) {
  const double half_px = 0.5 * nominal.marks.edge_m * nominal.camera.focal_px().y() / r_m;
  return guide_row_px - 0.8 * half_px;
}

/// Starts for the fit: the best angle of a grid, and its rivals.
std::vector<PyramidPlace> Starts(const Nominal& nominal, const TintMap& map,
                                 const GroundColour& ground, const OrangeSpot& spot,
                                 double pitch_rad, double r_m) {
  constexpr int kAngles = 24;
  constexpr double kFrom = Radians(-115.0), kStep = Radians(10.0);
  const std::array<double, 4> scales{0.75, 0.87, 1.0, 1.15};
  std::vector<PyramidPlace> all;
  for (int a = 0; a < kAngles; a += 3) {
    all.push_back(PlaceAt(nominal, spot.centre_px, pitch_rad, scales[0] * r_m, kFrom + a * kStep));
  }
  const auto window = WindowOn(map, ground, RectOf(nominal, map, all, MarksDrawn::kAll), kGridCells,
                               LowestHorizon(nominal, spot.centre_px.y(), r_m));
  if (!window) return {};
  const PlacePrior prior = PriorFor(nominal, pitch_rad, r_m);
  std::array<double, kAngles> costs{};
  std::array<PyramidPlace, kAngles> places;
  for (std::size_t a = 0; a < kAngles; ++a) {
    costs[a] = 1e30;
    for (const double scale : scales) {
      const PyramidPlace place = PlaceAt(nominal, spot.centre_px, pitch_rad, scale * r_m,
                                         kFrom + static_cast<double>(a) * kStep);
      const auto cost = CostOf(nominal, *window, place, prior, MarksDrawn::kAll);
      if (!cost || *cost >= costs[a]) continue;
      costs[a] = *cost;
      places[a] = place;
    }
  }
  std::vector<std::size_t> valleys;
  for (std::size_t a = 0; a < kAngles; ++a) {
    const bool low =
        (a == 0 || costs[a] <= costs[a - 1]) && (a + 1 == kAngles || costs[a] < costs[a + 1]);
    if (low && costs[a] < 1e29) valleys.push_back(a);
  }
  std::ranges::sort(valleys, [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  std::vector<PyramidPlace> starts;
  for (const std::size_t a : valleys) {
    if (starts.size() < 3) starts.push_back(places[a]);
  }
  return starts;
}

/// The fit, or a better one from a square that is larger or smaller.
PlaceFit FromOtherRanges(const Nominal& nominal, const FitWindow& window, const PlacePrior& prior,
                         const PlaceFit& fit) {
  PlaceFit best = fit;
  if (fit.misfit < kPoorMisfit || fit.misfit > kHopelessMisfit) return best;
  for (const double share : kOtherRanges) {
    PyramidPlace from = fit.place;
    from.X_VD.x *= share;
    from.X_VD.y *= share;
    const auto other = FitPlace(nominal, window, from, prior, MarksDrawn::kAll, 12);
    if (other && other->chi2 < best.chi2) best = *other;
  }
  return best;
}

/// Of the whole pyramid, the likeliest first. Only one that can be the pyramid is worth other
/// ranges: of other things they would make more that can.
std::vector<PlaceFit> FitsFrom(const Nominal& nominal, const TintMap& map,
                               const GroundColour& ground, const OrangeSpot& spot,
                               const PlacePrior& prior, double r_m, Expected expected,
                               const std::vector<PyramidPlace>& starts) {
  std::vector<PlaceFit> fits;
  if (starts.empty()) return fits;
  const auto window = WindowOn(map, ground, RectOf(nominal, map, starts, MarksDrawn::kAll),
                               r_m > kFine_m ? kFineFitCells : kFitCells,
                               LowestHorizon(nominal, spot.centre_px.y(), r_m));
  if (!window) return fits;
  for (const PyramidPlace& from : starts) {
    const auto fit = FitPlace(nominal, *window, from, prior, MarksDrawn::kAll, 12);
    if (fit) fits.push_back(*fit);
  }
  std::ranges::stable_sort(fits, {}, &PlaceFit::chi2);
  const auto first = std::ranges::find_if(
      fits, [&](const PlaceFit& fit) { return IsPyramid(fit, prior, expected); });
  if (first == fits.end()) return fits;
  *first = FromOtherRanges(nominal, *window, prior, *first);
  std::ranges::stable_sort(fits, {}, &PlaceFit::chi2);
  return fits;
}

std::optional<PlaceFit> GuideAlone(const Nominal& nominal, const TintMap& map,
                                   const GroundColour& ground, const OrangeSpot& spot,
                                   double pitch_rad, double r_m) {
  std::optional<PlaceFit> best;
  const std::vector<double> scales =
      spot.clipped ? std::vector<double>{1.0, 0.7} : std::vector<double>{1.0};
  for (const double scale : scales) {
    const auto place = [&](double alpha_rad) {
      return PlaceAt(nominal, spot.centre_px, pitch_rad, scale * r_m, alpha_rad);
    };
    auto window = WindowOn(map, ground, RectOf(nominal, map, {place(kPi / 2)}, MarksDrawn::kGuide),
                           kFitCells, LowestHorizon(nominal, spot.centre_px.y(), r_m));
    if (!window) continue;
    for (std::size_t k = 0; k < window->size(); ++k) {
      if (window->blue[k]) window->open[k] = 0.0f;  // nothing here explains it
    }
    PlacePrior prior = AlonePrior(nominal, pitch_rad, r_m);
    prior.mean[0] = place(0.0).X_VD.x;
    prior.sigma[0] = kAreaRangeSigma * r_m;
    for (const double alpha_rad : {0.0, Radians(70.0), Radians(-70.0)}) {
      const auto fit = FitPlace(nominal, *window, place(alpha_rad), prior, MarksDrawn::kGuide, 8);
      if (fit && (!best || fit->chi2 < best->chi2)) best = fit;
    }
  }
  return best;
}

}  // namespace

double RangeOfArea(const Nominal& nominal, double area_px2) {
  const Marks& marks = nominal.marks;
  const double radius_m = 0.5 * marks.guide_diameter_m;
  const double area_m2 = kPi * radius_m * radius_m;  // its side's differs by a twentieth
  return nominal.camera.focal_px().x() * std::sqrt(area_m2 / std::max(area_px2, 1.0));
}

double NominalDown(const Nominal& nominal) {
  return nominal.X_RC.p.z() + nominal.sprocket_radius_m - nominal.marks.guide_height_m;
}

std::optional<SpotFit> FitSpot(const Nominal& nominal, const TintMap& map, const OrangeSpot& spot,
                               double pitch_rad, const std::optional<Pose2>& start) {
  const auto ground = GroundAbout(map, spot.left, spot.right, spot.top, spot.bottom);
  if (!ground) return std::nullopt;
  const double r_m = RangeOfArea(nominal, spot.area_px2);
  const PyramidPlace nominal_place = PlaceAt(nominal, spot.centre_px, pitch_rad, r_m, 0.0);
  const double steeper = std::abs(nominal_place.pitch_rad - pitch_rad);
  if (steeper > 3.5 * kPitchSigma + 0.4 * NominalDown(nominal) / r_m) return std::nullopt;
  SpotFit out;
  out.clipped = spot.clipped;
  std::vector<PyramidPlace> starts;
  if (start) {
    starts.push_back(PlaceAt(nominal, spot.centre_px, pitch_rad, std::hypot(start->x, start->y),
                             AlphaOf(*start)));
  } else {
    starts = Starts(nominal, map, *ground, spot, pitch_rad, r_m);
  }
  const PlacePrior prior = PriorFor(nominal, pitch_rad, r_m);
  const Expected expected = start ? Expected::kThere : Expected::kAnywhere;
  const std::vector<PlaceFit> fits =
      FitsFrom(nominal, map, *ground, spot, prior, r_m, expected, starts);
  if (!fits.empty()) out.likely_alpha_rad = AlphaOf(fits.front().place.X_VD);
  std::ranges::copy_if(fits, std::back_inserter(out.poses),
                       [&](const PlaceFit& fit) { return IsPyramid(fit, prior, expected); });
  if (out.poses.size() > 2) out.poses.resize(2);
  if (out.poses.size() == 2) {
    const double scale = std::max(1.0, out.poses[0].misfit);
    const double apart =
        std::abs(WrapPi(out.poses[1].place.X_VD.heading - out.poses[0].place.X_VD.heading));
    if (out.poses[1].chi2 - out.poses[0].chi2 > kRivalChi2 * scale || apart < Radians(3.0)) {
      out.poses.pop_back();
    }
  }
  if (!out.poses.empty()) {
    out.guide = out.poses.front();
    return out;
  }
  const auto alone = GuideAlone(nominal, map, *ground, spot, pitch_rad, r_m);
  if (!alone) return std::nullopt;
  out.off_ground_chi2 = OffTheGround(alone->place, AlonePrior(nominal, pitch_rad, r_m));
  if (!IsGuide(*alone, out.off_ground_chi2, spot.clipped)) return std::nullopt;
  out.guide = *alone;
  if (!spot.clipped) out.without_square = AnglesWithoutSquare(nominal, map, alone->place);
  return out;
}

}  // namespace dockyard::raposa
