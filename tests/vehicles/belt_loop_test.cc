#include "sim/vehicles/belt_loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

BeltModel Rollers(Roller rear, Roller front) {
  BeltModel belt;
  belt.rear = rear;
  belt.front = front;
  return belt;
}
const BeltModel kTapered = Rollers({-0.1, 0.02, 0.09}, {0.2, -0.03, 0.05});

TEST(BeltLoop, IsAsLongAsAnOpenBeltRoundTwoPulleys) {
  EXPECT_NEAR(MakeBeltLoop(Rollers({-0.24, 0, 0.09}, {0.146, 0, 0.09})).length_m,
              2.0 * 0.386 + 2.0 * kPi * 0.09, 1e-12);
  // An open belt round two pulleys (any machine design handbook).
  const double apart = std::hypot(0.3, 0.05), wider = 0.04;
  const double length = 2.0 * std::sqrt(apart * apart - wider * wider) +
                        0.09 * (kPi + 2.0 * std::asin(wider / apart)) +
                        0.05 * (kPi - 2.0 * std::asin(wider / apart));
  EXPECT_NEAR(MakeBeltLoop(kTapered).length_m, length, 1e-12);
}

TEST(BeltLoop, IsOneSmoothClosedLine) {
  const BeltLoop loop = MakeBeltLoop(kTapered);
  for (std::size_t i = 0; i < 4; ++i) {
    const BeltSegment &here = loop.segments[i], &next = loop.segments[(i + 1) % 4];
    const LoopPlace end = PlaceOn(here, here.end_m), begin = PlaceOn(next, next.begin_m);
    EXPECT_LT((end.at - begin.at).norm(), 1e-12) << i;
    EXPECT_LT((end.along - begin.along).norm(), 1e-12) << i;
    const double middle = 0.5 * (here.begin_m + here.end_m), step = 1e-6;
    const Eigen::Vector2d moved = PlaceOn(here, middle + step).at - PlaceOn(here, middle - step).at;
    EXPECT_LT((moved / (2.0 * step) - PlaceOn(here, middle).along).norm(), 1e-9) << i;
  }
}

TEST(BeltLoop, RunsBackBelowAndForwardAbove) {
  const BeltLoop loop = MakeBeltLoop(kTapered);
  const LoopPlace below = PlaceOn(loop.segments[0], 0.0);
  const LoopPlace above = PlaceOn(loop.segments[2], loop.segments[2].begin_m);
  EXPECT_LT(below.along.x(), -0.9);
  EXPECT_LT(below.out.y(), -0.9);
  EXPECT_GT(above.along.x(), 0.9);
  EXPECT_GT(above.out.y(), 0.9);
}

TEST(PressedPart, IntegratesTheDepthThatIsPositive) {
  const double length = 0.028;
  for (const double middle : {-2e-3, -1e-5, 0.0, 1e-4, 5e-3}) {
    for (const double slope : {-0.4, -0.01, 0.0, 0.02, 0.5}) {
      for (const double curvature : {0.0, 2.0, 11.0, 30.0}) {
        const PressedPart part = PressedPartOf(middle, slope, curvature, length);
        double area = 0.0, moment = 0.0, pressed = 0.0;
        constexpr int kCells = 20000;
        for (int i = 0; i < kCells; ++i) {
          const double u = length * ((i + 0.5) / kCells - 0.5);
          const double h = middle + slope * u - 0.5 * curvature * u * u;
          if (h <= 0.0) continue;
          area += h * length / kCells;
          moment += h * u * length / kCells;
          pressed += length / kCells;
        }
        EXPECT_NEAR(part.area_m2, area, 1e-9);
        EXPECT_NEAR(part.moment_m3, moment, 1e-11);
        EXPECT_NEAR(part.high_m - part.low_m, pressed, 3.0 * length / kCells);
      }
    }
  }
}

}  // namespace
}  // namespace dockyard
