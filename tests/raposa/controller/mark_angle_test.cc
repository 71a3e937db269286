// Eqs. (2) and (7) against public vectors, and the two facts that the paper states of them.
#include "controller/raposa/mark_angle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::raposa {
namespace {

constexpr double kFocal = 377.0, kEdge = 0.06;
const double kBehind = 0.03 * std::tan(Radians(73.0));

/// As published, raposa.md 5.1: a pinhole, alpha > 0 with the blue right of the guide, the guide
/// right of the image's middle at a positive bearing, dz the camera above the guide, pitch down,
/// tilt turning the square about the guide with its top away from the robot.
struct Vector {
  double r_m, alpha_deg, bearing_deg, dz_m, pitch_deg, tilt_deg, c_px, g_px, alpha_eq7_deg, d_eq2_m;
};
constexpr std::array<Vector, 10> kVectors{{
    {2.00, 0, 0, 0, 0, 0, 5.390526, 10.781052, 0.0000, 2.09813},
    {1.33, 30, 0, 0, 0, 0, 20.208456, 16.157382, 30.0000, 1.39998},
    {2.00, 60, 0, 0, 0, 0, 18.631066, 11.180960, 60.0000, 2.02308},
    {0.50, 60, 0, 0, 0, 0, 72.057867, 43.243696, 60.0000, 0.52308},
    {1.50, 73, 0, 0, 0, 0, 25.789089, 15.080000, 72.9914, 1.50000},
    {1.50, 80, 0, 0, 0, 0, 25.812046, 15.206773, 66.0000, 1.48750},
    {1.50, 90, 0, 0, 0, 0, 25.165540, 15.387755, 56.0000, 1.47000},
    {1.50, 110, 0, 0, 0, 0, 25.846278, 15.727465, 56.9371, 1.43825},
    {1.33, 30, 6, 0.05, 0, 10, 21.010905, 16.468274, 31.2485, 1.37355},
    {1.33, 60, -6, 0.05, 5, 10, 28.806101, 16.864824, 70.1646, 1.34125},
}};

struct Lengths {
  double c_px = 0.0, g_px = 0.0;
};

/// The square's corners through a pinhole, in P: the guide's middle, x out along its axis.
Lengths Project(const Vector& at) {
  const double alpha = Radians(at.alpha_deg), pitch = Radians(at.pitch_deg);
  const double heading = alpha + kPi + Radians(at.bearing_deg);
  const Eigen::Vector3d camera(at.r_m * std::cos(alpha), at.r_m * std::sin(alpha), at.dz_m);
  const Eigen::Vector3d along(std::cos(heading) * std::cos(pitch),
                              std::sin(heading) * std::cos(pitch), -std::sin(pitch));
  const Eigen::Vector3d right(std::sin(heading), -std::cos(heading), 0.0);
  const Eigen::Vector3d down = along.cross(right);
  const auto pixel = [&](const Eigen::Vector3d& p_P) -> Eigen::Vector2d {
    const Eigen::Vector3d ray = p_P - camera;
    return Eigen::Vector2d(kFocal * right.dot(ray), kFocal * down.dot(ray)) / along.dot(ray);
  };
  const Eigen::Vector2d guide = pixel(Eigen::Vector3d::Zero());
  double low = 1e9, high = -1e9, far = 0.0;
  for (const double y : {-0.5, 0.5}) {
    for (const double z : {-0.5, 0.5}) {
      const Eigen::Vector3d corner(-kBehind, y * kEdge, z * kEdge);
      const Eigen::Vector2d at_px = pixel(RotY(-Radians(at.tilt_deg)) * corner);
      low = std::min(low, at_px.y());
      high = std::max(high, at_px.y());
      far = std::max(far, at_px.x() - guide.x());
    }
  }
  return {far, high - low};
}

MarkAngle Of(const Lengths& l) { return AngleOfMarks(l.c_px, l.g_px, kEdge, kBehind, kFocal); }

TEST(MarkAngle, GivesThePublicVectors) {
  for (std::size_t i = 0; i < kVectors.size(); ++i) {
    const Vector& at = kVectors[i];
    const MarkAngle angle = Of({at.c_px, at.g_px});
    const double within_deg = i == 4 ? 0.02 : 1e-3;  // at the turning point the sine is flat
    EXPECT_NEAR(Degrees(angle.alpha_rad), at.alpha_eq7_deg, within_deg) << i;
    EXPECT_NEAR(angle.d_m, at.d_eq2_m, 1e-5) << i;
  }
}

TEST(MarkAngle, TakesTheLengthsThatASquareHasBeforeAPinhole) {
  for (std::size_t i = 0; i < kVectors.size(); ++i) {
    const Lengths l = Project(kVectors[i]);
    EXPECT_NEAR(l.c_px, kVectors[i].c_px, 1e-6) << i;
    EXPECT_NEAR(l.g_px, kVectors[i].g_px, 1e-6) << i;
  }
}

// Not an approximation there: the far end and the tallest edge have one depth.
TEST(MarkAngle, IsExactForALevelCameraThatLooksAtTheGuide) {
  for (double alpha_deg = 0.0; alpha_deg < 73.0; alpha_deg += 4.0) {
    for (const double r_m : {0.3, 0.7, 2.0}) {
      const MarkAngle angle = Of(Project({r_m, alpha_deg, 0, 0, 0, 0, 0, 0, 0, 0}));
      EXPECT_NEAR(Degrees(angle.alpha_rad), alpha_deg, 1e-6);
      EXPECT_NEAR(angle.r_m, r_m, 1e-9);
    }
  }
}

// "The inflexion point corresponds to about 73 deg" (F, C.2): where c/g is largest.
TEST(MarkAngle, TurnsBackAtAtanOfTwoMOverH) {
  EXPECT_NEAR(Degrees(TurningPoint(kEdge, kBehind)), 73.0, 1e-9);
  double most = 0.0, most_at_deg = 0.0;
  for (double alpha_deg = 0.0; alpha_deg <= 90.0; alpha_deg += 0.25) {
    const Lengths l = Project({1.5, alpha_deg, 0, 0, 0, 0, 0, 0, 0, 0});
    if (l.c_px / l.g_px <= most) continue;
    most = l.c_px / l.g_px;
    most_at_deg = alpha_deg;
  }
  EXPECT_NEAR(most_at_deg, 73.0, 0.3);
  EXPECT_NEAR(most, 1.710, 1e-3);
  for (double beyond_deg = 74.0; beyond_deg <= 90.0; beyond_deg += 4.0) {
    const MarkAngle angle = Of(Project({1.5, beyond_deg, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_NEAR(Degrees(angle.alpha_rad), 146.0 - beyond_deg, 1e-6);
    EXPECT_NEAR(Degrees(angle.other_rad), beyond_deg, 1e-6);
  }
}

TEST(MarkAngle, SaysWhereTwoAnglesFitOrNone) {
  const auto at_ratio = [](double ratio) { return Of({10.0 * ratio, 10.0}); };
  const double longest = std::hypot(kBehind, 0.5 * kEdge);  // R
  const auto at_alpha = [&](double alpha_deg) {             // the formula's own c/g
    return at_ratio(longest / kEdge * std::sin(Radians(alpha_deg + 17.0)));
  };
  EXPECT_FALSE(at_alpha(0.0).ambiguous);
  EXPECT_FALSE(at_alpha(30.0).ambiguous);
  EXPECT_FALSE(at_alpha(35.9).ambiguous);  // the other is 110.1
  EXPECT_TRUE(at_alpha(36.1).ambiguous);   // the other is 109.9
  EXPECT_TRUE(at_alpha(72.0).ambiguous);
  EXPECT_TRUE(at_alpha(-1.0).ambiguous);  // none fits: -1 and 147
  const MarkAngle none = at_ratio(1.75);
  EXPECT_TRUE(none.beyond_root);
  EXPECT_TRUE(none.ambiguous);
  EXPECT_NEAR(Degrees(none.alpha_rad), 73.0, 1e-6);
  EXPECT_FALSE(at_alpha(72.0).beyond_root);
}

}  // namespace
}  // namespace dockyard::raposa
