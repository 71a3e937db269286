#include "controller/motion/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/rover_sample.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

std::vector<Arc> AnyPath(RandomStream& random) {
  return {{random.Uniform(-1, 1.5), random.Uniform(-1.5, 1.5)},
          {random.Uniform(-1, 1.5), random.Uniform(-1.5, 1.5)}};
}

// Points along the sides of polygons, at most step_m apart.
std::vector<Vector2d> PointsOf(const std::vector<Polygon>& polygons, double step_m) {
  std::vector<Vector2d> points;
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const int steps = static_cast<int>((b - a).norm() / step_m) + 1;
      for (int k = 0; k < steps; ++k) points.push_back(a + (b - a) * k / steps);
    }
  }
  return points;
}

// Of a convex polygon.
bool IsWithin(const Polygon& polygon, const Vector2d& p) {
  int left = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() > 0.0) ++left;
  }
  return left == 0 || left == static_cast<int>(polygon.size());
}

// By sampling the way and the outline; 0 where the outline passes over the disc's middle.
double Sampled(const RoverPlan& rover, const std::vector<Arc>& path, const Disc& disc) {
  double least = 1e9;
  Pose2 start;
  for (const Arc& arc : path) {
    const std::vector<Polygon> outline = OutlineOn(rover, arc);
    const std::vector<Vector2d> points = PointsOf(outline, 2e-3);
    constexpr int kSteps = 1600;
    for (int i = 0; i <= kSteps; ++i) {
      const Vector2d seen = Inverse(Advance(start, Part(arc, 1.0 * i / kSteps))) * disc.centre;
      for (const Polygon& part : outline) {
        if (IsWithin(part, seen)) least = 0.0;
      }
      for (const Vector2d& p : points) least = std::min(least, (seen - p).norm());
    }
    start = Advance(start, arc);
  }
  return least - disc.radius_m;
}

// Samples 2 mm apart on the outline, at most 2.5 mm of way apart, miss at most 2.3 mm.
TEST(Clearance, AgreesWithSamplesOfTheWayAndTheOutline) {
  RandomStream random(StreamKey(1, "clearance"));
  const RoverPlan rover = RockySample();
  int free = 0;
  for (int i = 0; i < 30; ++i) {
    const std::vector<Arc> path = AnyPath(random);
    const Disc disc{{random.Uniform(-0.8, 2), random.Uniform(-1, 1)}, 0.05};
    const double clear = Clearance(rover, path, {{disc}, {}}, 10.0);
    const double sampled = Sampled(rover, path, disc);
    if (clear > 0.0) ++free;
    EXPECT_LE(clear, sampled + 1e-12);
    EXPECT_GT(clear, sampled - 2.3e-3);
  }
  EXPECT_GT(free, 10);
  EXPECT_LT(free, 28);
}

// A fine regular polygon is nearly a disc.
TEST(Clearance, OfAPolygonIsThatOfTheDiscThatItDraws) {
  RandomStream random(StreamKey(2, "polygon"));
  const RoverPlan rover = RockySample();
  int free = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<Arc> path = AnyPath(random);
    const Disc disc{{random.Uniform(-1, 3), random.Uniform(-1.5, 1.5)}, 0.2};
    Polygon drawn;
    for (int k = 0; k < 128; ++k) {
      const double angle = 2.0 * kPi * k / 128;
      drawn.push_back(disc.centre + disc.radius_m * Vector2d(std::cos(angle), std::sin(angle)));
    }
    const double round = Clearance(rover, path, {{disc}, {}}, 0.3);
    const double cornered = Clearance(rover, path, {{}, {drawn}}, 0.3);
    if (round > 0.0) ++free;
    EXPECT_NEAR(cornered, round, 1e-3);
  }
  EXPECT_GT(free, 50);
  EXPECT_LT(free, 190);
}

TEST(Clearance, SeesAnObstacleThatOnlyASteeredWheelReaches) {
  RoverPlan rover = RockySample();
  const Arc left{0.4 * 0.5, 0.5};
  // Beside the outer edge of the left front wheel when it points ahead.
  const Obstacles near{{{{0.40875 - 0.03, 0.2 + 0.04 + 0.012}, 0.005}}, {}};
  EXPECT_GT(Clearance(rover, {{1e-6, 0.0}}, near, 1.0), 0.0);
  EXPECT_LE(Clearance(rover, {left}, near, 1.0), 0.0);
  EXPECT_LE(Clearance(rover, {{1e-6, 0.0}, left}, near, 1.0), 0.0);
}

TEST(Clearance, IsNotPositiveForAnObstacleInsideTheBodyOrRoundIt) {
  const RoverPlan rover = RockySample();
  const std::vector<Arc> path{{0.01, 0.0}};
  EXPECT_LE(Clearance(rover, path, {{{{0.2, 0.0}, 0.01}}, {}}, 1.0), 0.0);
  EXPECT_LE(Clearance(rover, path, {{}, {{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}}}, 1.0), 0.0);
  EXPECT_LE(Clearance(rover, path, {{{{0.2, 0.0}, 5.0}}, {}}, 1.0), 0.0);
}

// Rounding would make a free path a blocked one.
TEST(Clearance, IsExactlyWhatIsEnoughWhereNothingIsNearer) {
  RandomStream random(StreamKey(3, "enough"));
  const RoverPlan rover = RockySample();
  int free = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Arc> path = AnyPath(random);
    const Disc disc{{random.Uniform(-1, 3), random.Uniform(-1.5, 1.5)}, random.Uniform(0.03, 0.2)};
    const double enough = random.Uniform(0.01, 0.1);
    if (Clearance(rover, path, {{disc}, {}}, 10.0) < enough + 1e-12) continue;
    ++free;
    EXPECT_EQ(Clearance(rover, path, {{disc}, {}}, enough), enough);
  }
  EXPECT_GT(free, 500);
}

TEST(StandingClearance, IsThatOfTheBody) {
  const RoverPlan rover = RockySample();
  const Obstacles ahead{{{{2.0, 0.0}, 0.1}}, {}};
  EXPECT_NEAR(StandingClearance(rover, {1.0, 0.0, 0.0}, ahead, 5.0), 2.0 - 0.1 - 1.43, 1e-12);
}

}  // namespace
}  // namespace dockyard
