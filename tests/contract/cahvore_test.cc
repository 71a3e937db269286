// CAHV* models against published pixels and parameters.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "controller/geometry/lens.h"

namespace dockyard {
namespace {

// mrcal's test-projections.py: fx, fy, cx, cy, the tilt of O and three points.
const Eigen::Vector3d kMrcalPoints[] = {{1, 2, 10}, {-1.1, 0.3, 1}, {-0.9, -1.5, 1}};

Cahvore MrcalLens(double linearity, const Eigen::Vector3d& E) {
  const double alpha = -0.001, beta = 0.002;
  return {.A = {0, 0, 1},
          .H = {4842.918, 0, 1970.528},
          .V = {0, 4842.771, 1085.302},
          .O = {std::sin(alpha) * std::cos(beta), std::sin(beta), std::cos(alpha) * std::cos(beta)},
          .R = {-0.637, -0.002, 0.016},
          .E = E,
          .linearity = linearity};
}

struct MrcalCase {
  const char* name;
  double linearity;
  Eigen::Vector3d E;
  bool unit_points;  // its vectors with a moving pupil hold for points of length 1
  Eigen::Vector2d pixels[3];
};

class MrcalVectors : public testing::TestWithParam<MrcalCase> {};

TEST_P(MrcalVectors, AreReproduced) {
  const MrcalCase& c = GetParam();
  const Cahvore lens = MrcalLens(c.linearity, c.E);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d p = c.unit_points ? kMrcalPoints[i].normalized() : kMrcalPoints[i];
    const auto pixel = lens.Project(p, nullptr);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), c.pixels[i].x(), 1e-8);  // printed to 1e-8
    EXPECT_NEAR(pixel->y(), c.pixels[i].y(), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(, MrcalVectors,
                         testing::Values(MrcalCase{"cahvor",
                                                   1.0,
                                                   {0, 0, 0},
                                                   false,
                                                   {{2143.17840406, 1442.93419919},
                                                    {-92.63813066, 1653.09646897},
                                                    {-249.83199315, -2606.46477164}}},
                                         MrcalCase{"cahvore_tiny_pupil",
                                                   0.0,
                                                   {1e-8, 2e-8, 3e-8},
                                                   true,
                                                   {{2140.34076919, 1437.37148001},
                                                    {496.63465931, 1493.31670636},
                                                    {970.11788123, -568.30114806}}},
                                         MrcalCase{"cahvore_fisheye",
                                                   0.0,
                                                   {0.01, 0.02, 0.03},
                                                   true,
                                                   {{2140.35607966, 1437.40149368},
                                                    {489.05797783, 1495.37110356},
                                                    {954.60918375, -594.21144463}}},
                                         MrcalCase{"cahvore_linearity",
                                                   0.4,
                                                   {0.01, 0.02, 0.03},
                                                   true,
                                                   {{2140.80289923, 1438.27741040},
                                                    {423.27156274, 1513.20891648},
                                                    {872.53696336, -731.32905711}}}),
                         [](const auto& info) { return std::string(info.param.name); });

// Vision Workbench's TestCAHVOREModel: a Hazcam of the Mars Exploration Rovers.
Cahvore MerHazcam() {
  return {.C = {0.606185, -0.043367, -0.234891},
          .A = {0.712013, 0.037316, 0.701174},
          .H = {353.341, 474.873, 350.82},
          .V = {44.0102, 16.904, 683.916},
          .O = Eigen::Vector3d(0.712953, 0.038186, 0.700171).normalized(),
          .R = {3e-6, -0.013032, -0.00754},
          .E = {0.000942, 0.00228, 0.001613},
          .linearity = 0.37};
}

/// Cosine of the least angle from A at which a border pixel's ray lies, seen across `side`.
double LeastReach(const Cahvore& lens, const std::array<Eigen::Vector2d, 6>& border,
                  const Eigen::Vector3d& A, const Eigen::Vector3d& side) {
  double most = -1.0;
  for (const Eigen::Vector2d& pixel : border) {
    const Eigen::Vector3d ray = lens.Ray(pixel).direction;
    most = std::max(most, A.dot((ray - side.dot(ray) * side).normalized()));
  }
  return most;
}

// The linear CAHV camera of 1024 x 1024 pixels whose field just fits inside the Hazcam's: its
// axis is the ray of the middle, its half angles the least of the border's. Twelve rays make it.
TEST(VisionWorkbenchVector, LinearCameraInsideTheHazcamIsReproduced) {
  const Cahvore lens = MerHazcam();
  const double last = 1023, half = 511;  // that library's middle of the border is a whole pixel
  const Eigen::Vector3d A = lens.Ray({511.5, 511.5}).direction;
  const Eigen::Vector3d down0 = lens.A.cross(lens.H).normalized();
  const Eigen::Vector3d right = down0.cross(A).normalized(), down = A.cross(right);
  const double across = LeastReach(
      lens, {{{0, 0}, {0, half}, {0, last}, {last, 0}, {last, half}, {last, last}}}, A, down);
  const double along = LeastReach(
      lens, {{{0, 0}, {half, 0}, {last, 0}, {0, last}, {half, last}, {last, last}}}, A, right);
  const auto scale = [](double cosine) { return 512.0 / std::tan(std::acos(cosine)); };
  const Eigen::Vector3d H = scale(across) * right + 511.5 * A, V = scale(along) * down + 511.5 * A;
  const auto printed = [](const Eigen::Vector3d& v, double x, double y, double z, double digit) {
    return (v - Eigen::Vector3d(x, y, z)).cwiseAbs().maxCoeff() < digit;
  };
  EXPECT_TRUE(printed(A, 0.712254, 0.0290096, 0.701322, 0.6e-6)) << A.transpose();
  EXPECT_TRUE(printed(H, 358.009, 279.762, 354.175, 0.6e-3)) << H.transpose();
  EXPECT_TRUE(printed(V, 177.463, 13.6499, 548.543, 0.6e-3)) << V.transpose();
}

// Published with the models: Ingenuity's navigation camera has 3.6 mrad a pixel.
TEST(Cahvore, ScalesAreThoseOfItsVectors) {
  const Cahvore heli{
      .A = {0, 0, 1}, .H = {275.360101, 0, 327.204951}, .V = {0, 275.503134, 249.65619}};
  const CahvScales scales = ScalesOf(heli);
  EXPECT_NEAR(scales.hs, 275.360101, 1e-12);
  EXPECT_NEAR(scales.vc, 249.65619, 1e-12);
  EXPECT_NEAR(1.0 / scales.hs, 3.6e-3, 0.05e-3);
}

TEST(Cahvore, WithoutItsTermsIsAPinhole) {
  const Cahvore cahv{.C = {0.1, 0.2, 0.3}, .H = {600, 0, 512}, .V = {0, 590, 384}};
  const auto pixel = cahv.Project({0.6, -0.05, 1.3}, nullptr);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 512 + 600 * 0.5, 1e-10);
  EXPECT_NEAR(pixel->y(), 384 - 590 * 0.25, 1e-10);
}

}  // namespace
}  // namespace dockyard
