#include "sim/rigid/turned_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace dockyard {
namespace {

constexpr double kMargin = 1e-3;

TEST(TurnedShape, CylinderIsDrawnInByTheMarginAllRound) {
  const auto core = DrawnIn({{-0.02, 0.03}, {0.02, 0.03}}, kMargin);
  ASSERT_EQ(core.size(), 2u);
  EXPECT_NEAR(core[0].x(), -0.019, 1e-15);
  EXPECT_NEAR(core[1].x(), 0.019, 1e-15);
  for (const auto& corner : core) EXPECT_NEAR(corner.y(), 0.029, 1e-15);
}

TEST(TurnedShape, CornerThatIsNoneIsLeftOut) {
  const auto core = DrawnIn({{-0.02, 0.03}, {0.0, 0.03}, {0.02, 0.03}}, kMargin);
  ASSERT_EQ(core.size(), 2u);
  EXPECT_NEAR(core[1].x(), 0.019, 1e-15);
}

TEST(TurnedShape, SlantedSideIsDrawnInAcrossItself) {
  // A cone of 3 : 4; the distance of a core corner from the slanted line is the margin.
  const auto core = DrawnIn({{0.0, 0.05}, {0.04, 0.02}}, kMargin);
  const Eigen::Vector2d out(0.6, 0.8);
  for (const auto& corner : core) {
    EXPECT_NEAR(out.dot(Eigen::Vector2d(0.04, 0.02) - corner), kMargin, 1e-15);
  }
  EXPECT_NEAR(core.front().x(), 1e-3, 1e-15);
  EXPECT_NEAR(core.back().x(), 0.039, 1e-15);
}

TEST(TurnedShape, SupportIsTheFarthestPointOfTheSolid) {
  const std::vector<Eigen::Vector2d> profile{{-0.03, 0.031}, {0.0, 0.031}, {0.025, 0.0227}};
  const TurnedConvexShape shape(profile, kMargin);
  // Against a dense sampling of the drawn-in solid's surface plus the ball of the margin.
  const auto core = DrawnIn(profile, kMargin);
  for (const btVector3& raw : {btVector3(1, 0, 0), btVector3(0, -1, 0.2), btVector3(0.3, 0.4, 2),
                               btVector3(-1, 0.5, -3), btVector3(0, 0, -1), btVector3(0, 0, 1)}) {
    const btVector3 d = raw.normalized();
    double most = -1.0;
    for (const auto& corner : core) {
      for (int i = 0; i < 7200; ++i) {
        const double a = 2.0 * 3.14159265358979 * i / 7200;
        most = std::max(
            most, d.dot(btVector3(corner.y() * std::cos(a), corner.y() * std::sin(a), corner.x())));
      }
    }
    const double reach = d.dot(shape.localGetSupportingVertex(d));
    EXPECT_NEAR(reach, most + kMargin, 1e-8);
  }
}

TEST(TurnedShape, SurfaceIsWhereTheProfileSaysAcrossAndAlong) {
  const TurnedConvexShape shape({{-0.03, 0.031}, {0.0, 0.031}, {0.025, 0.0227}}, kMargin);
  EXPECT_NEAR(shape.localGetSupportingVertex(btVector3(1, 0, 0)).x(), 0.031, 1e-12);
  EXPECT_NEAR(shape.localGetSupportingVertex(btVector3(0, 0, 1)).z(), 0.025, 1e-12);
  EXPECT_NEAR(shape.localGetSupportingVertex(btVector3(0, 0, -1)).z(), -0.03, 1e-12);
}

TEST(TurnedShape, BoxHoldsTheTurnedSolid) {
  const TurnedConvexShape shape({{0.8, 0.031}, {0.9, 0.02}}, kMargin);
  btTransform X;
  X.setIdentity();
  X.setRotation(btQuaternion(btVector3(0, 1, 0), 0.5 * SIMD_PI));  // z to x
  btVector3 low, high;
  shape.getAabb(X, low, high);
  EXPECT_NEAR(low.x(), 0.8, 1e-12);
  EXPECT_NEAR(high.x(), 0.9, 1e-12);
  EXPECT_NEAR(high.y(), 0.031, 1.2e-4);  // the corner is rounded by the margin
  EXPECT_NEAR(low.z(), -high.z(), 1e-12);
}

TEST(TurnedShape, RefusesWhatIsNotConvexOrTooThin) {
  EXPECT_THROW(DrawnIn({{0.0, 0.03}, {0.01, 0.02}, {0.02, 0.03}}, kMargin), std::invalid_argument);
  EXPECT_THROW(DrawnIn({{0.02, 0.03}, {0.0, 0.03}}, kMargin), std::invalid_argument);
  EXPECT_THROW(DrawnIn({{0.0, 0.03}, {1.5e-3, 0.03}}, kMargin), std::invalid_argument);
  EXPECT_THROW(DrawnIn({{0.0, 0.5e-3}, {0.1, 0.5e-3}}, kMargin), std::invalid_argument);
  EXPECT_THROW(DrawnIn({{0.0, 0.03}}, kMargin), std::invalid_argument);
}

}  // namespace
}  // namespace dockyard
