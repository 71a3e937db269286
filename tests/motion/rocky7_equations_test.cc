// Equations (1)-(14) of Nesnas, Maimone and Das (ICRA 2000), computed here as printed, against the
// arcs. In (1) and (4) the paper exchanges P and G.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "controller/motion/two_arcs.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

Eigen::Matrix2d Turn(double angle_rad) { return Eigen::Rotation2Dd(angle_rad).toRotationMatrix(); }

double Radius(const Arc& arc) { return arc.length_m / arc.turn_rad; }

Vector2d AnyPoint(RandomStream& random) { return {random.Uniform(-2, 2), random.Uniform(-1, 1)}; }

// An arc that is neither straight nor a turn in place.
Arc AnyArc(RandomStream& random) {
  const double turn = random.Uniform(0.2, 2.5) * (random.Uniform(0, 1) < 0.5 ? -1.0 : 1.0);
  return {random.Uniform(0.3, 3.0) * (random.Uniform(0, 1) < 0.5 ? -1.0 : 1.0), turn};
}

TEST(Rocky7Equations, OneArcTurnsThePointAboutACentreOnTheAxle) {
  RandomStream random(StreamKey(1, "eq 1"));
  for (int i = 0; i < 500; ++i) {
    const Arc arc = AnyArc(random);
    const Vector2d P = AnyPoint(random), r(0.0, Radius(arc));
    const Vector2d G = r + Turn(arc.turn_rad) * (P - r);  // (1)
    EXPECT_LT((Advance({}, arc) * P - G).norm(), 1e-9);
  }
}

TEST(Rocky7Equations, OneArcHasThePrintedRadiusAndTurn) {
  RandomStream random(StreamKey(2, "eq 2"));
  for (int i = 0; i < 500; ++i) {
    const Vector2d P = AnyPoint(random), G = AnyPoint(random);
    if (std::abs(G.y() - P.y()) < 0.05 || std::abs(G.x() + P.x()) < 0.05) continue;
    const double theta = 2.0 * std::atan2(G.y() - P.y(), G.x() + P.x());  // (3)
    const double c = std::cos(theta), s = std::sin(theta);
    const double r_y = (G.x() - c * P.x() + s * P.y()) / s;  // (2)
    const auto arc = OneArcTo(G, P);
    ASSERT_TRUE(arc);
    EXPECT_NEAR(Radius(*arc), r_y, 1e-6 * (1.0 + std::abs(r_y)));
    // The same turn, or the rest of the circle the other way round.
    EXPECT_NEAR(std::remainder(arc->turn_rad - theta, 2.0 * kPi), 0.0, 1e-9);
  }
}

struct Constants {
  double c0, c1, c2, c3;
};
// (8)-(11), of the goal of the rover's origin.
Constants ConstantsOf(const Pose2& goal) {
  const double c = std::cos(goal.heading), s = std::sin(goal.heading);
  return {0.5 * (goal.x * goal.x + goal.y * goal.y), goal.y, goal.x * s - goal.y * c, c - 1.0};
}

// Pairs for goals of a point P of the rover, with what the equations need.
struct PairCase {
  Vector2d P, G;
  double theta_f;
  Pose2 origin;  // (13)
  ArcPair pair;
  double r1, r2;
};
PairCase AnyPair(RandomStream& random) {
  for (;;) {
    PairCase at;
    at.P = AnyPoint(random);
    at.G = 2.0 * AnyPoint(random);
    at.theta_f = random.Uniform(-3.0, 3.0);
    const double c = std::cos(at.theta_f), s = std::sin(at.theta_f);
    at.origin = {at.G.x() - (c * at.P.x() - s * at.P.y()), at.G.y() - (s * at.P.x() + c * at.P.y()),
                 at.theta_f};
    const auto pair = PairOfSplit(at.origin, random.Uniform(0.1, kPi - 0.1));
    if (!pair) continue;
    at.pair = *pair;
    at.r1 = Radius(at.pair[0]), at.r2 = Radius(at.pair[1]);
    const bool plain = std::abs(at.pair[0].turn_rad) > 0.05 && std::abs(at.pair[1].turn_rad) > 0.05;
    if (plain && std::abs(at.r1 - at.r2) > 0.05 && std::abs(at.r1) + std::abs(at.r2) < 50)
      return at;
  }
}

TEST(Rocky7Equations, TwoArcsTurnThePointAboutBothCentres) {
  RandomStream random(StreamKey(4, "eq 4"));
  for (int i = 0; i < 500; ++i) {
    const PairCase at = AnyPair(random);
    const Vector2d r1(0.0, at.r1), r2(0.0, at.r2);
    const Eigen::Matrix2d R1 = Turn(at.pair[0].turn_rad), R2 = Turn(at.pair[1].turn_rad);
    const Vector2d G = r1 - R1 * (r1 - r2) + R1 * R2 * (at.P - r2);  // (4)
    EXPECT_LT((G - at.G).norm(), 1e-7);
    // (5), (6): the same, written out for the origin.
    const double t1 = at.pair[0].turn_rad;
    EXPECT_NEAR(at.origin.x, (at.r1 - at.r2) * std::sin(t1) + at.r2 * std::sin(at.theta_f), 1e-7);
    EXPECT_NEAR(at.origin.y, at.r1 - (at.r1 - at.r2) * std::cos(t1) - at.r2 * std::cos(at.theta_f),
                1e-7);
  }
}

TEST(Rocky7Equations, OneRadiusFollowsFromTheOther) {
  RandomStream random(StreamKey(5, "eq 7"));
  for (int i = 0; i < 500; ++i) {
    const PairCase at = AnyPair(random);
    const Constants k = ConstantsOf(at.origin);
    // (7) multiplied out: c0 - c1 r1 = r2 (c2 + c3 r1).
    const double scale = 1.0 + std::abs(k.c0) + std::abs(at.r1) + std::abs(at.r1 * at.r2);
    EXPECT_NEAR(k.c0 - k.c1 * at.r1, at.r2 * (k.c2 + k.c3 * at.r1), 1e-9 * scale);
  }
}

TEST(Rocky7Equations, TheFirstTurnIsThePrintedOne) {
  RandomStream random(StreamKey(6, "eq 12"));
  for (int i = 0; i < 500; ++i) {
    const PairCase at = AnyPair(random);
    const double sign = at.r1 > at.r2 ? 1.0 : -1.0;
    const double theta1 =
        std::atan2((at.origin.x - at.r2 * std::sin(at.theta_f)) * sign,
                   (at.r1 - at.origin.y - at.r2 * std::cos(at.theta_f)) * sign);  // (12)
    EXPECT_NEAR(std::remainder(theta1 - at.pair[0].turn_rad, 2.0 * kPi), 0.0, 1e-6);
  }
}

TEST(Rocky7Equations, TheCostIsTwiceTheLongerArc) {
  RandomStream random(StreamKey(7, "eq 14"));
  for (int i = 0; i < 500; ++i) {
    const PairCase at = AnyPair(random);
    const double l1 = std::abs(at.r1 * at.pair[0].turn_rad);
    const double l2 = std::abs(at.r2 * at.pair[1].turn_rad);
    EXPECT_NEAR(PairCost(at.pair), l1 + l2 + std::abs(l1 - l2), 1e-9 * (1.0 + l1 + l2));  // (14)
  }
}

}  // namespace
}  // namespace dockyard
