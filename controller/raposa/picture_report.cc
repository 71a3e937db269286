#include "controller/raposa/picture_report.h"

#include <Eigen/Geometry>
#include <limits>

#include "controller/raposa/marks_projection.h"

namespace dockyard::raposa {
namespace {

constexpr int kGuideMark = 0, kBlueMark = 1;

/// RAPOSA's eyes fit areas of colour, not places of marks.
SightingReport OfThisSystem() {
  SightingReport report;
  report.method = "back";
  report.reprojection_px = std::numeric_limits<double>::quiet_NaN();
  return report;
}

SightingReport::Mark MarkAt(int id, const Eigen::Vector2d& px) {
  return {.id = id, .camera = kBackCamera, .u_px = px.x(), .v_px = px.y()};
}

Pose3 PyramidInBody(const Pose2& X_DN) {
  return FromGround(Inverse(X_DN * Pose2{0.0, 0.0, kPi}), 0.0);
}

Eigen::Vector2d MiddleOf(const ConvexPolygon& polygon) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < polygon.count; ++i) sum += polygon.corners[static_cast<std::size_t>(i)];
  return sum / polygon.count;
}

}  // namespace

SightingReport ReportOf(const PyramidSighting& sighting, const Pose2& X_DN,
                        const Nominal& nominal) {
  SightingReport report = OfThisSystem();
  report.accepted = !sighting.fits.empty();
  if (!report.accepted) report.reason = sighting.guide ? "the guide shows no marks" : "no guide";
  if (sighting.guide) report.marks = {MarkAt(kGuideMark, sighting.guide->centre_px)};
  report.detected = {static_cast<int>(report.marks.size())};
  if (sighting.fits.empty()) return report;
  const PyramidFit& fit = sighting.fits.front();
  report.X_RB = PyramidInBody(X_DN);
  const Eigen::Rotation2Dd R_RV(ToGround(report.X_RB).heading - fit.X_VD.heading);
  const Eigen::Matrix2d R = R_RV.toRotationMatrix();
  report.covariance.topLeftCorner<2, 2>() =
      R * fit.covariance.topLeftCorner<2, 2>() * R.transpose();
  report.covariance.block<2, 1>(0, 5) = R * fit.covariance.block<2, 1>(0, 2);
  report.covariance.block<1, 2>(5, 0) = report.covariance.block<2, 1>(0, 5).transpose();
  report.covariance(5, 5) = fit.covariance(2, 2);
  const auto marks = ProjectMarks(nominal, {fit.X_VD, fit.down_m, fit.pitch_rad, fit.roll_rad});
  if (!marks) return report;
  int id = kBlueMark;
  for (const ConvexPolygon& strip : marks->strips) {
    if (strip.count > 0) report.predicted.push_back(MarkAt(id, MiddleOf(strip)));
    ++id;
  }
  return report;
}

SightingReport ReportOf(const MarksSeen& sighting, const Pose2& X_DN) {
  SightingReport report = OfThisSystem();
  report.accepted = sighting.pair.has_value();
  if (!report.accepted) {
    report.reason = !sighting.orange ? "no ellipse" : !sighting.blue ? "no blue" : "no pair";
  }
  if (sighting.orange)
    report.marks.push_back(MarkAt(kGuideMark, sighting.orange->ellipse.centre_px));
  if (sighting.blue) report.marks.push_back(MarkAt(kBlueMark, sighting.blue->centre_px()));
  report.detected = {static_cast<int>(report.marks.size())};
  if (report.accepted) report.X_RB = PyramidInBody(X_DN);
  return report;
}

}  // namespace dockyard::raposa
