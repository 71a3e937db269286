#include "controller/stereo/ground_plane.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim/base/random.h"

namespace dockyard {
namespace {

// Ground that rises by 4 cm a metre ahead and falls by 2 cm a metre to the left, 3 cm higher than
// expected, with 4 mm of noise; a third of the points are of stones, up to 40 cm above it.
TEST(GroundPlane, IsThatOfTheGroundAmongStones) {
  RandomStream random(3);
  std::vector<Eigen::Vector3d> points;
  const Eigen::Vector3d truth(0.03, 0.04, -0.02);
  for (int i = 0; i < 3000; ++i) {
    const double x = 0.5 + 1.5 * random.Uniform(), y = random.Uniform() - 0.5;
    const double above_m = i % 3 == 0 ? 0.4 * random.Uniform() : 4e-3 * random.Normal();
    points.emplace_back(x, y, truth.dot(Eigen::Vector3d(1.0, x, y)) + above_m);
  }
  const auto plane = FitGroundPlane(points, Eigen::Vector3d::Zero(), 200);
  ASSERT_TRUE(plane);
  for (const double x : {0.5, 2.0}) {
    const Eigen::Vector3d at(1.0, x, 0.2);
    EXPECT_NEAR(plane->dot(at), truth.dot(at), 3e-3) << x;
  }
  EXPECT_FALSE(FitGroundPlane(points, {1.0, 0.0, 0.0}, 200));
}

}  // namespace
}  // namespace dockyard
