#include "controller/axel/tether_length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/motion/two_arcs.h"

namespace dockyard::axel {
namespace {

using testing::AllOf;
using testing::DoubleNear;
using testing::Ge;
using testing::Le;

// Everything at one point and one height: the paper's Eq. (1).
TetherGeometry PaperGeometry() {
  TetherGeometry geometry;
  geometry.arm_m = 1.0;
  return geometry;
}

TEST(Tether, CosineLawIsTheDistanceLeftWhenTheArmPointsAtTheStation) {
  EXPECT_DOUBLE_EQ(CosineLawTether(1.0, {4.0, 0.3, 0.3}), 3.0);
}

TEST(Tether, CosineLawIsPythagorasWithTheArmAcross) {
  EXPECT_THAT(CosineLawTether(1.0, {4.0, 0.5 * kPi, 0.0}), DoubleNear(std::sqrt(17.0), 1e-12));
}

TEST(Tether, ExactLengthIsTheCosineLawWhenAllIsAtTheOrigin) {
  const DockingCoords at{3.7, 0.5, -0.2};
  EXPECT_THAT(ExposedTether(PaperGeometry(), FromDockingCoords(at), 0.0),
              DoubleNear(CosineLawTether(1.0, at), 1e-12));
}

TEST(Tether, IsTheAnchorsDistanceFromTheTipWhenTheTipIsSeated) {
  const Nominal nominal = TestNominal();
  const TetherGeometry geometry = TetherGeometryOf(nominal);
  const double tilt = Radians(5.0);
  // Tip on the cone's axis, 25 cm deep.
  const double height = nominal.mouth_height_m + 0.25 * std::sin(tilt);
  const double elevation = std::asin(height - nominal.wheel_radius_m);
  const Pose2 seated{std::cos(elevation) - 0.25 * std::cos(tilt), 0.0, kPi};
  EXPECT_THAT(ExposedTether(geometry, seated, elevation), DoubleNear(0.10, 1e-9));
}

TEST(Tether, AnchorLiesBehindTheMouthAlongTheTippedAxis) {
  const Nominal nominal = TestNominal();
  const Eigen::Vector3d p_DA = TetherGeometryOf(nominal).p_DA;
  EXPECT_THAT(p_DA.x(), DoubleNear(-0.35 * std::cos(Radians(5.0)), 1e-12));
  EXPECT_THAT(p_DA.z(), DoubleNear(0.37 + 0.35 * std::sin(Radians(5.0)), 1e-12));
}

TEST(Tether, RateIsTheSlopeOfTheLengthAlongAnArc) {
  const TetherGeometry geometry = TetherGeometryOf(TestNominal());
  const Pose2 X_DR = FromDockingCoords({3.0, 0.4, 0.1});
  const double dt = 1e-3;
  const Pose2 later = Advance(X_DR, Arc{0.05 * dt, 0.08 * dt});
  const double slope =
      (ExposedTether(geometry, later, 0.1) - ExposedTether(geometry, X_DR, 0.1)) / dt;
  EXPECT_THAT(ExposedTetherRate(geometry, X_DR, 0.1, 0.05, 0.08), DoubleNear(slope, 1e-5));
}

TEST(Tether, ShortensAsFastAsTheRoverDrivesWhenTheArmPointsAtIt) {
  EXPECT_THAT(ExposedTetherRate(PaperGeometry(), FromDockingCoords({4.0, 0.0, 0.0}), 0.0, 0.05, 0),
              DoubleNear(-0.05, 1e-9));
}

/// The linear approximation of the paper (IV-A): most slack (positive) and most shortage
/// (negative) against the exact length when the spool turns evenly over each arc [m].
struct LinearTetherError {
  double most_slack_m = 0.0, most_shortage_m = 0.0;
};
LinearTetherError LinearTetherErrorAlong(const TetherGeometry& geometry, const Pose2& X_DR_start,
                                         const std::vector<Arc>& arcs) {
  constexpr int kSamples = 200;
  LinearTetherError error;
  Pose2 start = X_DR_start;
  for (const Arc& arc : arcs) {
    const Pose2 end = Advance(start, arc);
    const double from = ExposedTether(geometry, start, 0.0), to = ExposedTether(geometry, end, 0.0);
    for (int i = 0; i <= kSamples; ++i) {
      const double share = static_cast<double>(i) / kSamples;
      const double given = from + share * (to - from);
      const double slack = given - ExposedTether(geometry, Advance(start, Part(arc, share)), 0.0);
      error.most_slack_m = std::max(error.most_slack_m, slack);
      error.most_shortage_m = std::min(error.most_shortage_m, slack);
    }
    start = end;
  }
  return error;
}

struct LinearCase {
  double alpha_deg, turn_low_deg, turn_high_deg, slack_low_m, slack_high_m;
};

// Two symmetric arcs from 4 m to 1.5 m on the axis: the closed form, evaluated independently, puts
// the slack of the even schedule at 35-65 mm for turns of 21-29 deg and 118-258 mm for 40-58 deg.
class LinearTether : public testing::TestWithParam<LinearCase> {};

TEST_P(LinearTether, SlackGrowsWithTheTurnAsTheClosedFormSays) {
  const LinearCase& at = GetParam();
  const Pose2 X_DR = FromDockingCoords({4.0, Radians(at.alpha_deg), 0.0});
  const auto pair =
      CheapestPair(Inverse(X_DR) * Pose2{1.5, 0.0, kPi}, {1.0 / 3.0, Travel::kForward});
  ASSERT_TRUE(pair);
  const std::vector<Arc> arcs(pair->begin(), pair->end());
  EXPECT_THAT(Degrees(std::abs(arcs.front().turn_rad)),
              AllOf(Ge(at.turn_low_deg), Le(at.turn_high_deg)));
  EXPECT_THAT(LinearTetherErrorAlong(PaperGeometry(), X_DR, arcs).most_slack_m,
              AllOf(Ge(at.slack_low_m), Le(at.slack_high_m)));
}

INSTANTIATE_TEST_SUITE_P(Turns, LinearTether,
                         testing::Values(LinearCase{4.0, 10, 16, 0.010, 0.022},
                                         LinearCase{7.0, 21, 29, 0.030, 0.065},
                                         LinearCase{14.0, 40, 58, 0.110, 0.260}));

TEST(LinearTether, IsExactOnAStraightRunAtTheStation) {
  const auto error =
      LinearTetherErrorAlong(PaperGeometry(), FromDockingCoords({4.0, 0.2, 0.2}), {{2.0, 0.0}});
  EXPECT_LT(error.most_slack_m, 1e-9);
  EXPECT_GT(error.most_shortage_m, -1e-9);
}

}  // namespace
}  // namespace dockyard::axel
