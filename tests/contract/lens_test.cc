// Properties of every lens model: projection and back, derivatives, and what it cannot see.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "controller/geometry/camera.h"

namespace dockyard {
namespace {

struct Sample {
  std::string name;
  Camera camera;
};

/// Navcam left of Mars 2020 (nasa-jpl/m2020-urdf-models) in a frame of its own: a real moving
/// pupil, turned any way.
Cahvore Navcam() {
  return {.C = {0.12848, -0.214947, -0.056891},
          .A = {0.999943, -0.005833, 0.00885},
          .H = {2612.926691, 2943.39557, 14.632299},
          .V = {1916.489292, -3.389678, 2975.009835},
          .O = Eigen::Vector3d(0.99995, -0.004409, 0.008967).normalized(),
          .R = {2e-6, 0.049535, -0.015973},
          .E = {-0.003612, 0.013016, -0.023961},
          .linearity = 0.37};
}

Cahvore Hazcam() {
  return {.C = {1.103534, -0.008945, -0.729124},
          .A = {0.884935, -0.17181, 0.432865},
          .H = {2606.49053, 1675.438136, 1273.544923},
          .V = {747.819318, -326.899856, 2757.18855},
          .O = Eigen::Vector3d(0.885293, -0.171227, 0.432363).normalized(),
          .R = {1e-6, 0.00889, -0.006754},
          .E = {-0.006127, 0.010389, 0.004541},
          .linearity = 0.37};
}

/// MSL's left Navcam, a CAHVOR model (label NRB_701383954).
Cahvore MslNavcam() {
  return {.C = {0.953083, 0.737269, -1.83989},
          .A = {0.61802, -0.158336, 0.770042},
          .H = {622.069, 1100.35, 388.444},
          .V = {-588.816, 157.005, 1176.66},
          .O = Eigen::Vector3d(0.615108, -0.158211, 0.772395).normalized(),
          .R = {1.35787e-5, 0.00183074, -0.0057552}};
}

BrownPinhole Webcam() {
  return {.fx = 535.4,
          .fy = 539.1,
          .cx = 320.1,
          .cy = 247.6,  //
          .k1 = -0.265,
          .k2 = -0.047,
          .k3 = 0.252,
          .p1 = 0.0018,
          .p2 = -0.0003};
}

/// Of the size of an Azure Kinect's: terms that nearly cancel between the two polynomials.
RationalPinhole DepthCamera() {
  return {.fx = 905.2,
          .fy = 904.8,
          .cx = 640.3,
          .cy = 362.9,
          .k = {0.512, -2.61, 1.47, 0.395, -2.43, 1.40},
          .p1 = 0.0005,
          .p2 = -0.0002};
}

DoubleSphere WideSphere() {
  return {.fx = 413.2, .fy = 413.1, .cx = 638.7, .cy = 514.4, .xi = -0.183, .alpha = 0.592};
}

Eucm WideEllipsoid() {
  return {.fx = 481.5, .fy = 481.3, .cx = 637.9, .cy = 514.9, .alpha = 0.631, .beta = 1.044};
}

Omni Mirror() {
  return {.fx = 1165.1,
          .fy = 1164.2,
          .cx = 639.5,
          .cy = 481.7,
          .xi = 1.372,
          .k1 = -0.121,
          .k2 = 0.043,
          .p1 = 0.0011,
          .p2 = -0.0006};
}

std::vector<Sample> Samples() {
  const KannalaBrandt fisheye{
      .fx = 558.478087865323,
      .fy = 560.506767351568,
      .cx = 620.458515360843,
      .cy = 381.939424848348,
      .k = {-0.0014613319981768, -0.00329861110580401, 0.00605760088590183, -0.00374209380722371}};
  Cahvore sine = Navcam();
  sine.linearity = -0.4;
  Cahvore cahv = MslNavcam();
  cahv.R.setZero();
  const auto own = [](const Cahvore& lens) { return InFrame(lens, CameraFrameOf(lens)); };
  return {
      {"kannala_brandt", {1280, 800, fisheye}},
      {"equidistant", EquidistantCamera(1024, 768, Radians(90))},
      {"brown", {640, 480, Webcam()}},
      {"rational", {1280, 720, DepthCamera()}},
      {"rational_without_quotient",
       {640, 480,
        RationalPinhole{.fx = 620,
                        .fy = 621,
                        .cx = 322,
                        .cy = 241,
                        .k = {-0.171, 0.094, 0, 0, 0, 0},
                        .p1 = 0.0012}}},
      {"double_sphere", {1280, 1024, WideSphere()}},
      {"double_sphere_of_small_alpha",
       {640, 480,
        DoubleSphere{.fx = 400, .fy = 400, .cx = 319, .cy = 239, .xi = 0.3, .alpha = 0.4}}},
      {"eucm", {1280, 1024, WideEllipsoid()}},
      {"omni", {1280, 960, Mirror()}},
      {"omni_of_small_xi",
       {640, 480, Omni{.fx = 500, .fy = 501, .cx = 320, .cy = 240, .xi = 0.8, .k1 = -0.05}}},
      {"fov", {640, 480, FovPinhole{.fx = 320, .fy = 321, .cx = 318, .cy = 242, .w_rad = 0.93}}},
      {"cahv", {1024, 1024, own(cahv)}},
      {"cahvor", {1024, 1024, own(MslNavcam())}},
      {"cahvore_hazcam", {5120, 3840, own(Hazcam())}},
      {"cahvore_navcam", {5120, 3840, own(Navcam())}},
      {"cahvore_negative_linearity", {5120, 3840, own(sine)}}};
}

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

class EveryLens : public testing::TestWithParam<Sample> {
 protected:
  const Camera& camera_ = GetParam().camera;
  /// Pixels over the whole image, its outer edges and corners included.
  std::vector<Eigen::Vector2d> Pixels() const {
    std::vector<Eigen::Vector2d> pixels{camera_.centre_px()};
    for (int i = 0; i <= 12; ++i) {
      for (int j = 0; j <= 12; ++j) {
        pixels.emplace_back(camera_.width * (i / 12.0) - 0.5, camera_.height * (j / 12.0) - 0.5);
      }
    }
    return pixels;
  }
};

TEST_P(EveryLens, RayComesBackToItsPixelFromNearToFar) {
  double worst = 0.0;
  for (const Eigen::Vector2d& pixel : Pixels()) {
    const LensRay ray = camera_.Ray(pixel);
    EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-14);
    for (const double range_m : {0.3, 1.0, 5.0, 30.0}) {
      const auto back = camera_.Project(ray.origin + range_m * ray.direction);
      ASSERT_TRUE(back) << pixel.transpose() << " at " << range_m;
      worst = std::max(worst, (*back - pixel).norm());
    }
  }
  EXPECT_LT(worst, 1e-8);
}

TEST_P(EveryLens, DerivativeIsThatOfCentralDifferences) {
  const double focal = camera_.focal_px().x();
  for (const Eigen::Vector2d& pixel : Pixels()) {
    for (const double range_m : {0.3, 5.0}) {
      const LensRay ray = camera_.Ray(pixel);
      const Eigen::Vector3d p = ray.origin + range_m * ray.direction;
      PixelJacobian J;
      const auto at = camera_.Project(p, J);
      ASSERT_TRUE(at);
      EXPECT_EQ(*at, *camera_.Project(p));
      const double step = 1e-4 * range_m;
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d d = step * Eigen::Vector3d::Unit(axis);
        const auto difference = [&](double times) {
          return Eigen::Vector2d(
              (*camera_.Project(p + times * d) - *camera_.Project(p - times * d)) /
              (2.0 * times * step));
        };
        // Richardson's extrapolation: truncation of order step^4.
        const Eigen::Vector2d slope = (4.0 * difference(0.5) - difference(1.0)) / 3.0;
        EXPECT_LT((slope - J.col(axis)).norm(), 1e-7 * focal / range_m)
            << pixel.transpose() << " at " << range_m << " axis " << axis;
      }
    }
  }
}

TEST_P(EveryLens, SeesNothingBehindIt) {
  const LensRay axis = camera_.Ray(camera_.centre_px());
  EXPECT_FALSE(camera_.Project(axis.origin - axis.direction));
  EXPECT_FALSE(camera_.Project(axis.origin - 20.0 * axis.direction));
  const Eigen::Vector3d side = axis.direction.unitOrthogonal();
  EXPECT_FALSE(camera_.Project(axis.origin - axis.direction + 0.1 * side));
  EXPECT_FALSE(camera_.Project(axis.origin));
}

TEST_P(EveryLens, KeepsItsViewOnASmallerImage) {
  const Camera half = Resized(camera_, camera_.width / 2, camera_.height / 2);
  for (const double x : {0.0, 0.3, 1.0}) {
    const Eigen::Vector2d share(x, 1.0 - x);
    const auto edge = [&](const Camera& c) {
      return c.Direction({share.x() * c.width - 0.5, share.y() * c.height - 0.5});
    };
    EXPECT_LT((edge(half) - edge(camera_)).norm(), 1e-12);
  }
}

TEST_P(EveryLens, MovesItsCentreAndStretchesItsFocalLength) {
  const Camera moved = Adjusted(camera_, 1.002, {1.5, -0.7});
  const Eigen::Vector2d centre = camera_.centre_px();
  EXPECT_NEAR(moved.focal_px().x() / camera_.focal_px().x(), 1.002, 1e-6);
  // CAHV* stretch about A, not about O, which may lie some pixels off.
  EXPECT_LT((moved.centre_px() - centre - Eigen::Vector2d(1.5, -0.7)).norm(), 0.1);
}

TEST_P(EveryLens, BendsByThatManyPixelsHalfTheImageOut) {
  const Camera bent = Bent(camera_, 0.5);
  const Eigen::Vector2d centre = camera_.centre_px();
  for (const double part : {0.5, 1.0}) {
    const Eigen::Vector2d pixel = centre - Eigen::Vector2d(0.5 * part * camera_.width, 0.0);
    const LensRay ray = camera_.Ray(pixel);
    const auto moved = bent.Project(ray.origin + 3.0 * ray.direction);
    ASSERT_TRUE(moved);
    // Within a tenth at the edge, a quarter halfway: the terms go with the models' own distances
    // off the axis, not with the pixels.
    const double share = part == 1.0 ? 0.1 : 0.25;
    const double cube = 0.5 * part * part * part;
    EXPECT_NEAR(pixel.x() - moved->x(), cube, share * cube);
  }
}

TEST(Cahvore, ShowsTheSameInEveryFrame) {
  const Cahvore lens_F = Hazcam();
  const Pose3 X_FC = CameraFrameOf(lens_F);
  const Cahvore lens_C = InFrame(lens_F, X_FC);
  EXPECT_EQ(lens_C.C, Eigen::Vector3d::Zero());
  EXPECT_LT((lens_C.A.normalized() - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
  EXPECT_NEAR(lens_C.H.y(), 0.0, 1e-12);
  EXPECT_GT(lens_C.V.y(), 0.0);
  const Eigen::Vector3d p_F(3.0, 0.2, 0.4);
  const auto from_F = lens_F.Project(p_F, nullptr);
  const auto from_C = lens_C.Project(Inverse(X_FC) * p_F, nullptr);
  ASSERT_TRUE(from_F && from_C);
  EXPECT_LT((*from_F - *from_C).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(, EveryLens, testing::ValuesIn(Samples()),
                         [](const auto& info) { return info.param.name; });

/// Points over the image give the pixels of OpenCV's projectPoints with these coefficients.
template <typename L, int kCount>
void ExpectAsOpenCv(const L& lens, const cv::Vec<double, kCount>& D) {
  const cv::Matx33d K(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
  for (const double x : {-0.6, -0.2, 0.0, 0.5}) {
    for (const double y : {-0.4, 0.1, 0.45}) {
      const std::vector<cv::Point3d> points{{2 * x, 2 * y, 2.0}};
      std::vector<cv::Point2d> pixels;
      cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), K, D, pixels);
      const auto pixel = lens.Project({2 * x, 2 * y, 2.0}, nullptr);
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x(), pixels[0].x, 1e-10);
      EXPECT_NEAR(pixel->y(), pixels[0].y, 1e-10);
    }
  }
}

TEST(BrownPinhole, ProjectsAsOpenCvDoes) {
  const BrownPinhole lens = Webcam();
  ExpectAsOpenCv(lens, cv::Vec<double, 5>(lens.k1, lens.k2, lens.p1, lens.p2, lens.k3));
}

TEST(RationalPinhole, ProjectsAsOpenCvDoes) {
  for (const RationalPinhole& lens : {DepthCamera(), RationalPinhole{.fx = 620.5,
                                                     .fy = 621.3,
                                                     .cx = 322.1,
                                                     .cy = 241.7,
                                                     .k = {5.1, 3.2, 0.17, 5.4, 4.9, 0.96},
                                                     .p1 = 0.0004,
                                                     .p2 = -0.0003}}) {
    const auto& k = lens.k;
    ExpectAsOpenCv(lens, cv::Vec<double, 8>(k[0], k[1], lens.p1, lens.p2, k[2], k[3], k[4], k[5]));
  }
}

// With its terms zero or at their limits each of these is a lens that is known by another name.
TEST(SphereLenses, HaveTheirKnownLimits) {
  const BrownPinhole pinhole{.fx = 400, .fy = 410, .cx = 320, .cy = 240};
  const BrownPinhole bent{
      .fx = 400, .fy = 410, .cx = 320, .cy = 240, .k1 = -0.1, .k2 = 0.02, .p1 = 1e-3, .p2 = -2e-3};
  // alpha 1 / 2 and beta 1 is Mei's model with xi 1: (x, y) / ((d + z) / 2).
  const Omni unified{.fx = 200, .fy = 205, .cx = 320, .cy = 240, .xi = 1.0};
  const Eucm half{.fx = 100, .fy = 102.5, .cx = 320, .cy = 240, .alpha = 0.5, .beta = 1.0};
  const DoubleSphere no_shift{.fx = 100, .fy = 102.5, .cx = 320, .cy = 240, .xi = 0, .alpha = 0.5};
  const auto near = [](const auto& a, const auto& b, const Eigen::Vector3d& p) {
    const auto pa = a.Project(p, nullptr), pb = b.Project(p, nullptr);
    return pa && pb && (*pa - *pb).norm() < 1e-10;
  };
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.3, -0.2, 1.0), Eigen::Vector3d(-1, 0.4, 2)}) {
    EXPECT_TRUE(near(pinhole, Omni{.fx = 400, .fy = 410, .cx = 320, .cy = 240}, p));
    EXPECT_TRUE(near(pinhole, Eucm{.fx = 400, .fy = 410, .cx = 320, .cy = 240}, p));
    EXPECT_TRUE(near(pinhole, DoubleSphere{.fx = 400, .fy = 410, .cx = 320, .cy = 240}, p));
    EXPECT_TRUE(
        near(pinhole, FovPinhole{.fx = 400, .fy = 410, .cx = 320, .cy = 240, .w_rad = 1e-7}, p));
    EXPECT_TRUE(near(bent,
                     Omni{.fx = 400,
                          .fy = 410,
                          .cx = 320,
                          .cy = 240,
                          .k1 = -0.1,
                          .k2 = 0.02,
                          .p1 = 1e-3,
                          .p2 = -2e-3},
                     p));
    EXPECT_TRUE(near(half, no_shift, p));
    // u - cx is fx x / (z + d) for one, and 2 fx' x / (z + d) with fx' = fx / 2 for the other.
    EXPECT_TRUE(near(unified, half, p));
  }
}

// Worked by hand from the equations of the papers.
TEST(SphereLenses, ProjectAsTheirPapersSay) {
  const Eigen::Vector3d p(0.6, 0.0, 0.8);  // of length 1: d1 = 1
  const DoubleSphere sphere{.fx = 100, .fy = 100, .cx = 0, .cy = 0, .xi = -0.2, .alpha = 0.6};
  // z1 = 0.6, d2 = 0.6 sqrt(2).
  EXPECT_NEAR(sphere.Project(p, nullptr)->x(), 60.0 / (0.36 * std::sqrt(2.0) + 0.24), 1e-12);
  const Eucm ellipsoid{.fx = 100, .fy = 100, .cx = 0, .cy = 0, .alpha = 0.6, .beta = 2.0};
  EXPECT_NEAR(ellipsoid.Project(p, nullptr)->x(),
              60.0 / (0.6 * std::sqrt(2.0 * 0.36 + 0.64) + 0.4 * 0.8), 1e-12);
  const Omni omni{.fx = 100, .fy = 100, .cx = 0, .cy = 0, .xi = 1.2, .k1 = 0.5};
  EXPECT_NEAR(omni.Project(p, nullptr)->x(), 30.0 * (1.0 + 0.5 * 0.09), 1e-12);  // 0.6 / 2
  const FovPinhole fov{.fx = 100, .fy = 100, .cx = 0, .cy = 0, .w_rad = kPi / 2};
  EXPECT_NEAR(fov.Project(p, nullptr)->x(), 100.0 * std::atan(1.5) / (kPi / 2), 1e-12);
}

TEST(SphereLenses, KnowWhichPixelsHaveNoRay) {
  // Just inside and just outside the greatest radius that a point is shown at.
  const auto reach = [](const Lens& lens, double radius_px) {
    const Camera camera{1000, 1000, lens};
    return std::pair(camera.HasRay({500 + 0.99 * radius_px, 500}),
                     camera.HasRay({500 + 1.01 * radius_px, 500}));
  };
  const auto only_inside = std::pair(true, false);
  const double wide = 100 / std::sqrt(2.0 * 0.95 - 1.0);  // 93 deg off the axis
  EXPECT_EQ(reach(Eucm{.fx = 100, .fy = 100, .cx = 500, .cy = 500, .alpha = 0.95}, wide),
            only_inside);
  EXPECT_EQ(reach(Omni{.fx = 100, .fy = 100, .cx = 500, .cy = 500, .xi = 2.5},
                  100 / std::sqrt(2.5 * 2.5 - 1.0)),
            only_inside);
  EXPECT_EQ(reach(FovPinhole{.fx = 100, .fy = 100, .cx = 500, .cy = 500, .w_rad = 0.9},
                  100 * kPi / 2 / 0.9),
            only_inside);
}

// A quotient may unfold again beyond its fold: the part there has no rays.
TEST(RationalPinhole, ShowsNothingFromBeyondItsFirstFold) {
  const RationalPinhole lens{
      .fx = 500, .fy = 500, .cx = 320, .cy = 240, .k = {-0.5, 0.06, 0.0, 0.0, 0.0, 0.0}};
  // r (1 - 0.5 s + 0.06 s^2) has the slope 1 - 1.5 s + 0.3 s^2: zero at s = 0.793 and 4.21.
  EXPECT_TRUE(lens.Project({std::sqrt(0.78), 0, 1}, nullptr));
  EXPECT_FALSE(lens.Project({std::sqrt(0.81), 0, 1}, nullptr));
  EXPECT_FALSE(lens.Project({std::sqrt(4.5), 0, 1}, nullptr));
  const Camera camera{640, 480, lens};
  const double peak = std::sqrt(0.793) * (1 - 0.5 * 0.793 + 0.06 * 0.793 * 0.793);
  EXPECT_TRUE(camera.HasRay({320 + 500 * (peak - 0.005), 240}));
  EXPECT_FALSE(camera.HasRay({320 + 500 * (peak + 0.005), 240}));
}

// Without the check, barrel distortion brings points far outside back into the image.
TEST(BrownPinhole, ShowsNothingFromBeyondItsFold) {
  const BrownPinhole lens{.fx = 500, .fy = 500, .cx = 320, .cy = 240, .k1 = -0.3};
  EXPECT_TRUE(lens.Project({1.0, 0.0, 1.0}, nullptr));  // fold at r = 1 / sqrt(0.9) = 1.054
  EXPECT_FALSE(lens.Project({1.1, 0.0, 1.0}, nullptr));
  const Camera camera{640, 480, lens};
  EXPECT_TRUE(camera.HasRay({320 + 500 * 0.70, 240}));  // the fold lies at 0.7027 f
  EXPECT_FALSE(camera.HasRay({320 + 500 * 0.71, 240}));
}

TEST(KannalaBrandt, ShowsNothingFromBeyondItsPeak) {
  const KannalaBrandt lens{.fx = 300, .fy = 300, .cx = 320, .cy = 240, .k = {-0.2, 0, 0, 0}};
  const double peak = std::sqrt(1.0 / 0.6);  // 1 = 3 x 0.2 theta^2
  const auto at = [](double theta) { return Eigen::Vector3d(std::sin(theta), 0, std::cos(theta)); };
  EXPECT_TRUE(lens.Project(at(peak - 0.01), nullptr));
  EXPECT_FALSE(lens.Project(at(peak + 0.01), nullptr));
}

TEST(Fisheyes, SeeBesideThemselvesAndAPinholeDoesNot) {
  const Eigen::Vector3d beside(1.0, 0.0, -0.05);  // 93 deg off the axis
  EXPECT_TRUE(EquidistantCamera(640, 480, Radians(170)).Project(beside));
  Cahvore wide{.H = {300, 0, 320}, .V = {0, 300, 240}, .linearity = 0.37};
  const auto pixel = wide.Project(beside, nullptr);
  ASSERT_TRUE(pixel);
  EXPECT_GT(pixel->x(), 320);
  wide.linearity = 1.0;
  EXPECT_FALSE(wide.Project(beside, nullptr));
  EXPECT_FALSE(Webcam().Project(beside, nullptr));
}

// Its own pupil is the reason why a CAHVORE pixel depends on the range, not the bearing alone.
TEST(MovingPupil, ShiftsTheHazcamsCornerByMillimetres) {
  const LensRay corner = Hazcam().Ray({0, 0}), middle = Hazcam().Ray({2560, 1920});
  EXPECT_NEAR((corner.origin - middle.origin).norm(), 0.012, 0.002);  // 12 mm
  const Eigen::Vector3d p = corner.origin + 2.0 * corner.direction;
  const Cahvore lens = Hazcam();
  Cahvore central = lens;
  central.E.setZero();
  const double px = (*central.Project(p, nullptr) - *lens.Project(p, nullptr)).norm();
  EXPECT_NEAR(px, 15.0, 2.0);  // of 5120 at 2 m
}

}  // namespace
}  // namespace dockyard
