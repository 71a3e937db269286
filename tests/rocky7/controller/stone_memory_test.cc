#include "controller/rocky7/stone_memory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard::rocky7 {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kUp_m = 0.3;  // the cameras over the ground
const FieldSettings kField;

FieldStone Stone(const Vector2d& p, double sigma_m = 0.004, double real = 0.9) {
  return {.p = p,
          .spread_m2 = sigma_m * sigma_m * Matrix2d::Identity(),
          .height_m = 0.02,
          .height_sigma_m = 0.003,
          .ground_m = 0.0,
          .real = real};
}

// A click on the middle of a stone of 2 cm at a place, from above the origin.
ClickRay ClickOn(const Vector2d& p) {
  return {.along = p / (kUp_m - 0.01), .range_data = p, .up_m = kUp_m, .sigma_rad = 0.006};
}

/// None of the stones was found again.
FieldMatch None(const StoneMemory& memory) {
  return {.seen = std::vector<int>(memory.stones().size(), -1)};
}

/// The one at this place was found again.
FieldMatch OnlyAt(const Vector2d& p, const StoneMemory& memory) {
  FieldMatch match = None(memory);
  auto was = memory.stones().begin();
  for (int& index : match.seen) index = (was++)->p == p ? 0 : -1;
  return match;
}

/// The target alone was found again.
FieldMatch TargetAlone(const StoneMemory& memory) {
  FieldMatch match = None(memory);
  match.seen[0] = 0;
  return match;
}

StoneMemory Begun(const std::vector<FieldStone>& stones, const Vector2d& click) {
  StoneMemory memory;
  memory.Begin(ClickOn(click), 0.0, stones);
  return memory;
}

TEST(ClickRay, MeetsEachHeightWhereSimilarTrianglesSay) {
  const ClickRay ray = ClickOn({0.9, 0.3});
  for (const double height_m : {0.0, 0.01, 0.05}) {
    const double share = (kUp_m - height_m) / (kUp_m - 0.01);
    EXPECT_LT((ray.At(height_m) - share * Vector2d(0.9, 0.3)).norm(), 1e-12);
  }
}

// An angle's error moves the place by (r^2 + h^2) / h along the ray and by the range across it.
TEST(ClickRay, IsLongerAlongTheRayThanAcross) {
  const ClickRay ray = ClickOn({0.9, 0.0});
  const Matrix2d spread = ray.SpreadAt(0.01);
  const double r = 0.9, h = kUp_m - 0.01;
  EXPECT_NEAR(std::sqrt(spread(1, 1)), 0.006 * std::hypot(r, h), 1e-9);
  EXPECT_GT(std::sqrt(spread(0, 0)), 0.006 * (r * r + h * h) / h);
  EXPECT_NEAR(spread(0, 1), 0.0, 1e-12);
}

TEST(StoneMemory, TakesTheStoneThatWasClickedOn) {
  for (const std::size_t clicked : {0u, 1u, 2u}) {
    const std::vector<FieldStone> stones{Stone({0.9, 0.0}), Stone({0.9, 0.12}), Stone({1.1, -0.2})};
    const StoneMemory memory = Begun(stones, stones[clicked].p);
    EXPECT_EQ(memory.target().p, stones[clicked].p);
  }
}

TEST(StoneMemory, WithoutAStoneOnTheRayTheClicksPlaceIsTheTarget) {
  StoneMemory memory;
  EXPECT_FALSE(memory.Begin(ClickOn({0.9, 0.0}), 0.0, {Stone({0.9, 0.3})}));
  EXPECT_LT((memory.target().p - Vector2d(0.9, 0.0)).norm(), 1e-9);
  EXPECT_FALSE(memory.HasSeenTargetWell());
}

// Two independent measurements of a place: the inverse variances add up, the mean is weighted.
TEST(StoneMemory, FusesASecondSightingByInverseVariances) {
  StoneMemory memory = Begun({Stone({0.9, 0.0}, 0.004)}, {0.9, 0.0});
  const std::vector<FieldStone> again{Stone({0.91, 0.0}, 0.008)};
  memory.Learn(again, TargetAlone(memory), kField);
  const double w = 1.0 / (0.004 * 0.004), w2 = 1.0 / (0.008 * 0.008), best2 = 0.002 * 0.002;
  EXPECT_NEAR(memory.target().p.x(), (w * 0.9 + w2 * 0.91) / (w + w2), 1e-12);
  EXPECT_NEAR(memory.target().spread_m2(0, 0), 1.0 / (w + w2) + best2, 1e-12);
  EXPECT_NEAR(memory.target().real, 1.0 - 0.1 * 0.1, 1e-12);
  EXPECT_TRUE(memory.HasSeenTargetWell());
}

// A stone's edge was taken for a stone of its own. Where images do not show that again, but the
// stone next to it, the two are one; a stone of its own is further away.
TEST(StoneMemory, ASettledTargetThatIsNotDetectedAgainWasAPartOfTheStoneNextToIt) {
  for (const double away_m : {0.028, 0.05}) {
    const Vector2d edge(0.5, 0.0), whole(0.5 - away_m, 0.01);
    StoneMemory memory = Begun({Stone(edge), Stone(whole)}, edge);
    memory.Settle();
    for (int pair = 0; pair < 2; ++pair) {
      memory.Choose();
      EXPECT_EQ(memory.target().p, edge);
      memory.Learn({Stone(whole)}, OnlyAt(whole, memory), kField);
    }
    memory.Choose();
    EXPECT_LT((memory.target().p - (away_m < 0.04 ? whole : edge)).norm(), 1e-6) << away_m;
  }
}

// One stone was detected as two, 2 cm apart, and the target is the place that images do not show
// again. Stones 3 cm apart are two.
TEST(StoneMemory, TwoPlacesOfOneStoneBecomeOne) {
  for (const double away_m : {0.02, 0.03}) {
    const Vector2d wrong(0.9, 0.0), right(0.9 + away_m, 0.0);
    StoneMemory memory = Begun({Stone(wrong), Stone(right)}, wrong);
    ASSERT_EQ(memory.target().p, wrong);
    memory.Learn({Stone(right)}, OnlyAt(right, memory), kField);
    EXPECT_EQ(memory.stones().size(), away_m < 0.025 ? 1u : 2u);
    EXPECT_EQ((memory.target().p - right).norm() < 1e-9, away_m < 0.025);
  }
}

TEST(StoneMemory, AStoneThatWasDetectedOftenCanStillFade) {
  StoneMemory memory = Begun({Stone({0.9, 0.0})}, {0.9, 0.0});
  for (int pair = 0; pair < 30; ++pair) {
    memory.Learn({Stone({0.9, 0.0})}, TargetAlone(memory), kField);
  }
  for (int pair = 0; pair < 8; ++pair) memory.Learn({}, None(memory), kField);
  EXPECT_LT(memory.target().real, 0.1);
}

// Bayes: of a stone that is there a share is missed, of none all.
TEST(StoneMemory, AStoneThatIsMissedFadesAsBayesSays) {
  StoneMemory memory = Begun({Stone({0.9, 0.0})}, {0.9, 0.0});
  memory.Learn({}, None(memory), kField);
  const double missed = 1.0 - kField.seen_again;
  EXPECT_NEAR(memory.target().real, 0.9 * missed / (0.9 * missed + 0.1), 1e-12);
}

TEST(StoneMemory, ForgetsWhatFadesButNeverTheTarget) {
  StoneMemory memory = Begun({Stone({0.9, 0.0}), Stone({0.9, 0.3})}, {0.9, 0.0});
  for (int i = 0; i < 6; ++i) {
    memory.Learn({}, None(memory), kField);
  }
  ASSERT_EQ(memory.stones().size(), 1u);
  EXPECT_EQ(memory.target().p, Vector2d(0.9, 0.0));
}

TEST(StoneMemory, RemembersAtMostThirteen) {
  std::vector<FieldStone> stones;
  for (int i = 0; i < 30; ++i) stones.push_back(Stone({0.5 + 0.05 * i, 0.0}));
  StoneMemory memory = Begun({Stone({0.9, 0.0})}, {0.9, 0.0});
  memory.Learn(stones, None(memory), kField);
  EXPECT_EQ(memory.stones().size(), 13u);
}

TEST(StoneMemory, TakesWhatTheClickMeantWhenItIsFoundLaterUnlessSettled) {
  for (const bool settled : {false, true}) {
    StoneMemory memory = Begun({Stone({1.0, 0.0}, 0.02, 0.4)}, {0.9, 0.0});
    if (settled) memory.Settle();
    memory.Learn({Stone({0.9, 0.0})}, None(memory), kField);
    memory.Choose();
    EXPECT_EQ((memory.target().p - Vector2d(0.9, 0.0)).norm() < 1e-9 && memory.HasSeenTargetWell(),
              !settled);
  }
}

// A frame has no meaning: turned and shifted, the same stone is chosen, at the same place.
TEST(StoneMemory, TurnsAndShiftsWithItsFrame) {
  const std::vector<FieldStone> stones{Stone({0.9, 0.0}), Stone({1.0, 0.1})};
  StoneMemory memory = Begun(stones, stones[1].p);
  const Pose2 X_ET{0.2, -0.1, 0.7};
  memory.Turn(X_ET);
  EXPECT_LT((memory.target().p - X_ET * stones[1].p).norm(), 1e-12);
  memory.Shift({0.05, 0.02});
  EXPECT_LT((memory.target().p - X_ET * stones[1].p - Vector2d(0.05, 0.02)).norm(), 1e-12);
  const Vector2d before = memory.target().p;
  memory.Choose();
  EXPECT_EQ(memory.target().p, before);
}

TEST(StoneMemory, APushedStoneMayLieFurtherOff) {
  StoneMemory memory = Begun({Stone({0.9, 0.0}, 0.004)}, {0.9, 0.0});
  memory.Loosen(0.02);
  EXPECT_NEAR(memory.target().spread_m2(0, 0), 0.004 * 0.004 + 0.02 * 0.02, 1e-15);
}

}  // namespace
}  // namespace dockyard::rocky7
