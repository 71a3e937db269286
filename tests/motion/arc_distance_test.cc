// Distances from a part that sweeps along an arc, against places sampled along both.
#include "controller/motion/arc_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

// By the place's distance from the segment at many places of the way.
double Sampled(const Pose2& X_AR, const Arc& arc, const Vector2d& p_RP, const Vector2d& p_RE,
               const Vector2d& p_AQ, int steps) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const Pose2 at = Advance(X_AR, Part(arc, static_cast<double>(i) / steps));
    const Vector2d a = at * p_RP, b = at * p_RE;
    const double squared = (b - a).squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp((p_AQ - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, (p_AQ - a - share * (b - a)).norm());
  }
  return least;
}

TEST(SweptDistance, OfAPointOnAStraightIsThatFromTheSegment) {
  const Vector2d middle(0.0, 0.0);
  EXPECT_NEAR(SweptDistance({}, {2.0, 0.0}, middle, middle, {1.0, 0.5}), 0.5, 1e-12);
  EXPECT_NEAR(SweptDistance({}, {2.0, 0.0}, middle, middle, {5.0, 4.0}), 5.0, 1e-12);
  EXPECT_NEAR(SweptDistance({}, {-2.0, 0.0}, middle, middle, {1.0, 0.0}), 1.0, 1e-12);
}

TEST(SweptDistance, OfAWheelOnACircleIsTheDifferenceOfRadii) {
  // The middle goes round (0, 2) by a quarter; the right wheel on a radius of 2.4.
  const Vector2d wheel(0.0, -0.4), aside(2.0, 0.0);  // 2 sqrt 2 from the centre, within the quarter
  EXPECT_NEAR(SweptDistance({}, {kPi, 0.5 * kPi}, wheel, wheel, aside), 2.0 * std::sqrt(2.0) - 2.4,
              1e-12);
}

TEST(SweptDistance, OfATurnInPlaceIsThatFromTheTipsCircle) {
  const Vector2d tip(1.0, 0.0);
  EXPECT_NEAR(SweptDistance({}, {0.0, 0.5 * kPi}, tip, tip, {1.0, 1.0}), std::sqrt(2.0) - 1.0,
              1e-12);
  EXPECT_NEAR(SweptDistance({}, {0.0, 0.5 * kPi}, tip, tip, {1.0, -1.0}), 1.0, 1e-12);
  EXPECT_NEAR(SweptDistance({}, {0.0, 2.0 * kPi}, tip, tip, {0.0, -1.5}), 0.5, 1e-12);
}

TEST(SweptDistance, IsTheLeastOfTheSampledPlaces) {
  RandomStream draw(11);
  int over = 0, beside = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose2 X_AR{draw.Uniform(-1, 1), draw.Uniform(-1, 1), draw.Uniform(-3, 3)};
    const Arc arc{draw.Uniform(-2, 2), i % 5 == 0 ? 0.0 : draw.Uniform(-3, 3)};
    const Vector2d p(draw.Uniform(-1, 1), draw.Uniform(-1, 1));
    const Vector2d e = i % 3 == 0 ? p : Vector2d(draw.Uniform(-1, 1), draw.Uniform(-1, 1));
    const Vector2d q(draw.Uniform(-1.2, 1.2), draw.Uniform(-1.2, 1.2));
    const double exact = SweptDistance(X_AR, arc, p, e, q);
    constexpr int kSteps = 2000;
    // No part moves by more than this between two samples.
    const double step_m = (std::abs(arc.length_m) + 1.5 * std::abs(arc.turn_rad)) / kSteps;
    const double sampled = Sampled(X_AR, arc, p, e, q, kSteps);
    EXPECT_LE(exact, sampled + 1e-9) << i;
    EXPECT_GE(exact, sampled - step_m) << i;
    ++(exact == 0.0 ? over : beside);
  }
  EXPECT_GT(over, 20);
  EXPECT_GT(beside, 200);
}

}  // namespace
}  // namespace dockyard
