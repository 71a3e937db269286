// What the two eyes report of a picture, on pictures that another painter draws.
#include "controller/raposa/picture_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raposa/controller/drawn_marks.h"

namespace dockyard::raposa {
namespace {

using Mark = SightingReport::Mark;

/// Of three channels at a mark: blue over red.
double Blueness(const RgbImage& image, const Mark& mark) {
  const auto x = static_cast<std::size_t>(std::lround(mark.u_px)),
             y = static_cast<std::size_t>(std::lround(mark.v_px));
  const std::size_t at = 3 * (y * static_cast<std::size_t>(image.width) + x);
  return static_cast<double>(image.pixels[at + 2]) / (1.0 + image.pixels[at]);
}

TEST(PictureReport, PutsItsMarksWhereThePictureHasTheirColours) {
  const Nominal nominal = TestNominal();
  const Pose2 X_PC = CameraAt(0.8, Radians(35.0));
  const RgbImage image = Draw(nominal, X_PC, {.camera_up_m = 0.02, .noise = 2.0});
  const PyramidPrior prior{Inverse(X_PC),
                           Eigen::Vector3d(1e-2, 1e-2, 1e-1).cwiseAbs2().asDiagonal()};
  const PyramidSighting sighting = PyramidFinder(nominal).Find(image, 0.0, prior);
  ASSERT_FALSE(sighting.fits.empty());
  const SightingReport report = ReportOf(sighting, Inverse(sighting.fits.front().X_VD), nominal);
  EXPECT_TRUE(report.accepted);
  ASSERT_EQ(report.marks.size(), 1u);
  EXPECT_EQ(report.DetectedBy(kBackCamera), 1);
  EXPECT_LT(Blueness(image, report.marks.front()), 0.5);
  EXPECT_GE(report.predicted.size(), 3u);
  for (const Mark& mark : report.predicted) EXPECT_GT(Blueness(image, mark), 2.0) << mark.id;
}

TEST(PictureReport, OfThePublishedEyeHasTheEllipseAndTheBlue) {
  const Nominal nominal = TestNominal();
  const RgbImage image = Draw(nominal, CameraAt(0.8, Radians(35.0)), {.strip_m = 0.0});
  MarkTracker tracker(nominal);
  const MarksSeen sighting = tracker.Find(image, nominal.ferreira_vision);
  ASSERT_TRUE(sighting.pair);
  const SightingReport report = ReportOf(sighting, CameraAt(0.8, Radians(35.0)));
  EXPECT_TRUE(report.accepted);
  ASSERT_EQ(report.marks.size(), 2u);
  EXPECT_LT(Blueness(image, report.marks[0]), 0.5);
  EXPECT_GT(Blueness(image, report.marks[1]), 2.0);
}

// The robot stands 1 m out on the guide's axis, its back to the guide: the guide is behind it.
TEST(PictureReport, GivesPoseAndCovarianceInTheRobotsBody) {
  PyramidSighting sighting;
  sighting.guide = GuideSighting{};
  PyramidFit fit;
  fit.X_VD = {0.75, 0.0, kPi};  // the camera looks along the axis
  fit.covariance << 4e-4, 0.0, 1e-5, 0.0, 1e-4, 2e-5, 1e-5, 2e-5, 9e-4;
  sighting.fits = {fit};
  const SightingReport report = ReportOf(sighting, {1.0, 0.0, kPi}, TestNominal());
  EXPECT_LT((report.X_RB.p - Eigen::Vector3d(-1.0, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(ToGround(report.X_RB).heading, 0.0, 1e-12);
  EXPECT_NEAR(report.covariance(0, 0), 4e-4, 1e-15);
  EXPECT_NEAR(report.covariance(1, 1), 1e-4, 1e-15);
  EXPECT_NEAR(report.covariance(5, 5), 9e-4, 1e-15);
  EXPECT_NEAR(report.covariance(0, 5), -1e-5, 1e-15);
  EXPECT_NEAR(report.covariance(5, 1), -2e-5, 1e-15);
}

TEST(PictureReport, TellsWhyAPictureIsNotTaken) {
  EXPECT_EQ(ReportOf(PyramidSighting{}, {}, TestNominal()).reason, "no guide");
  PyramidSighting guide;
  guide.guide = GuideSighting{};
  guide.guide->centre_px = {100.0, 120.0};
  const SightingReport report = ReportOf(guide, {}, TestNominal());
  EXPECT_FALSE(report.accepted);
  EXPECT_EQ(report.reason, "the guide shows no marks");
  ASSERT_EQ(report.marks.size(), 1u);
  EXPECT_EQ(report.marks.front().u_px, 100.0);
  EXPECT_EQ(ReportOf(MarksSeen{}, {}).reason, "no ellipse");
}

}  // namespace
}  // namespace dockyard::raposa
