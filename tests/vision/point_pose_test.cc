#include "controller/vision/point_pose.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "controller/vision/p3p.h"
#include "models/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

const StereoRig kRig = TestRig(1024, 768);
const Pose3 kBody{RotZ(0.3) * RotY(-0.2) * RotX(0.1), {2.5, 0.3, 0.2}};

/// Points of a body seen by the chosen cameras, with noise.
std::vector<PointPixel> Seen(const std::vector<Eigen::Vector3d>& points_B, bool left, bool right,
                             double noise_px, std::uint64_t seed = 3) {
  RandomStream random(seed);
  std::vector<PointPixel> seen;
  for (const Eigen::Vector3d& p_B : points_B) {
    for (int view = 0; view < 2; ++view) {
      if (view == 0 ? !left : !right) continue;
      const Camera& camera = view == 0 ? kRig.left : kRig.right;
      const Pose3 X_CB = Inverse(view == 0 ? kRig.X_RL : kRig.X_RQ) * kBody;
      seen.push_back({.p_B = p_B,
                      .view = view,
                      .pixel = *camera.Project(X_CB * p_B) +
                               noise_px * Eigen::Vector2d(random.Normal(), random.Normal())});
    }
  }
  return seen;
}

std::vector<Eigen::Vector3d> Solid() {
  return {{-.4, -.2, 0}, {.4, -.2, .1},  {.4, .3, -.2},  {-.4, .3, .2},
          {0, 0, .3},    {.1, -.3, -.1}, {-.2, .1, -.3}, {.3, .05, .25}};
}
std::vector<Eigen::Vector3d> Plane() {
  // In the body's y-z plane, so that the planarity is found and not assumed to be z = 0.
  return {{0, -.4, -.2}, {0, .4, -.2}, {0, .4, .3}, {0, -.4, .3}, {0, .1, 0}, {0, -.2, .15}};
}

void ExpectNear(const Pose3& X, double place_m, double turn_rad) {
  EXPECT_LT((X.p - kBody.p).norm(), place_m);
  EXPECT_LT(Eigen::AngleAxisd(X.R.transpose() * kBody.R).angle(), turn_rad);
}

TEST(ThreePoints, OneOfThePosesIsTheTrueOne) {
  RandomStream random(5);
  for (int i = 0; i < 50; ++i) {
    const auto draw = [&] {
      return Eigen::Vector3d(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    };
    const std::array<Eigen::Vector3d, 3> p{draw(), draw(), draw()};
    const Pose3 X_CB{RotZ(random.Uniform(-3, 3)) * RotX(random.Uniform(-3, 3)), {0.1, -0.2, 4.0}};
    const std::array<Eigen::Vector3d, 3> sights{
        (X_CB * p[0]).normalized(), (X_CB * p[1]).normalized(), (X_CB * p[2]).normalized()};
    double nearest = 1e9;
    for (const Pose3& X : PosesFromThreePoints(p, sights)) {
      nearest = std::min(nearest, (X.p - X_CB.p).norm());
    }
    EXPECT_LT(nearest, 1e-4) << i;
  }
}

TEST(ThreePoints, OnALineGiveNone) {
  const std::array<Eigen::Vector3d, 3> line{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                            Eigen::Vector3d(2, 0, 0)};
  EXPECT_TRUE(PosesFromThreePoints(line, {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(),
                                          Eigen::Vector3d::UnitZ()})
                  .empty());
}

TEST(PointPose, SolvesAnyBodyInOneCameraOrTwo) {
  for (const auto& points : {Solid(), Plane()}) {
    for (const auto& [left, right] : {std::pair(true, true), {true, false}, {false, true}}) {
      const auto pose = PoseFromPoints(Seen(points, left, right, 0.0), kRig, {});
      ASSERT_TRUE(pose);
      EXPECT_EQ(pose->method, left && right ? "stereo" : left ? "left" : "right");
      ExpectNear(pose->fit.X_RB, 1e-4, 1e-4);
    }
  }
}

TEST(PointPose, LeavesOutliersOut) {
  for (const auto& points : {Solid(), Plane()}) {
    std::vector<PointPixel> seen = Seen(points, true, true, 0.1);
    seen[1].pixel += Eigen::Vector2d(60.0, -25.0);
    seen[4].pixel += Eigen::Vector2d(-15.0, 40.0);
    seen[7].pixel += Eigen::Vector2d(9.0, 9.0);
    const auto pose = PoseFromPoints(seen, kRig, {});
    ASSERT_TRUE(pose);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(pose->inlier[i], i != 1 && i != 4 && i != 7) << i;
    }
    ExpectNear(pose->fit.X_RB, 0.01, 0.01);
  }
}

TEST(PointPose, TwoCamerasOfDifferentPointsAreEnough) {
  std::vector<PointPixel> seen;
  const auto all = Seen(Solid(), true, true, 0.05);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].view == static_cast<int>((i / 2) % 2)) seen.push_back(all[i]);
  }
  const auto pose = PoseFromPoints(seen, kRig, {});
  ASSERT_TRUE(pose);
  ExpectNear(pose->fit.X_RB, 0.01, 0.01);
}

TEST(PointPose, GivesBothBranchesOfAPlaneInOneCamera) {
  std::vector<Eigen::Vector3d> small = Plane();  // little perspective over it
  for (Eigen::Vector3d& p_B : small) p_B *= 0.3;
  const auto pose = PoseFromPoints(Seen(small, true, false, 0.02), kRig, {});
  ASSERT_TRUE(pose);
  ASSERT_TRUE(pose->other_RB);
  EXPECT_GT(pose->other_cost, pose->fit.cost);
  const Eigen::Vector3d normal = kBody.R.col(0), sight = (kBody.p - kRig.X_RL.p).normalized();
  const Eigen::Vector3d mirrored = 2.0 * normal.dot(sight) * sight - normal;
  EXPECT_GT(pose->fit.X_RB.R.col(0).dot(normal), std::cos(Radians(5.0)));
  EXPECT_GT(pose->other_RB->R.col(0).dot(mirrored), std::cos(Radians(5.0)));
}

TEST(PointPose, ThePapersNeedsAPlaneWithOneCamera) {
  const VisionSettings tsai{.pipeline = VisionPipeline::kTsai2013};
  EXPECT_FALSE(PoseFromPoints(Seen(Solid(), true, false, 0.0), kRig, tsai));
  const auto stereo = PoseFromPoints(Seen(Solid(), true, true, 0.0), kRig, tsai);
  ASSERT_TRUE(stereo);
  ExpectNear(stereo->fit.X_RB, 1e-6, 1e-6);
  const auto mono = PoseFromPoints(Seen(Plane(), true, false, 0.0), kRig, tsai);
  ASSERT_TRUE(mono);
  ExpectNear(mono->fit.X_RB, 0.3, 0.3);  // the lens's distortion is left out
}

TEST(PointPose, SaysWhatIsMissing) {
  const auto few = PoseFromPoints({}, kRig, {});
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error(), PoseFailure::kTooFewFiducials);
}

TEST(PointPose, CovarianceTellsTheScatter) {
  // Noise alone: no calibration spread in the world, so the told sigma may not be below the
  // scatter; with sigma 0.15 px assumed and 0.15 drawn it may not be far above in the depth either.
  double depth2 = 0.0, told2 = 0.0;
  constexpr int kTimes = 60;
  for (int i = 0; i < kTimes; ++i) {
    const auto points = Seen(Solid(), true, true, 0.15, static_cast<std::uint64_t>(i + 1));
    RefineOptions options;
    options.spread = {.focal = 0.0, .centre_px = 0.0, .mounting_rad = 0.0};
    options.fit_turn = false;
    const RefinedPose fit =
        RefinePoints(points, {{kRig.left, kRig.X_RL}, {kRig.right, kRig.X_RQ}}, kBody, options);
    depth2 += std::pow(fit.X_RB.p.x() - kBody.p.x(), 2) / kTimes;
    told2 += fit.covariance(0, 0) / kTimes;
  }
  EXPECT_NEAR(std::sqrt(depth2 / told2), 1.0, 0.25);
}

TEST(PointPose, CovarianceFollowsTheNoiseOfAnybodysPoints) {
  // Mean square over covariance of six numbers is 6 when the covariance is right. With 0.15 px
  // assumed for all, 0.8 px of noise gave above 100.
  for (const double noise_px : {0.15, 0.8}) {
    for (const bool both : {true, false}) {
      double sum = 0.0;
      constexpr int kTimes = 80;
      for (int i = 0; i < kTimes; ++i) {
        const auto pose = PoseFromPoints(
            Seen(Solid(), true, both, noise_px, static_cast<std::uint64_t>(i + 1)), kRig, {});
        ASSERT_TRUE(pose);
        const Eigen::AngleAxisd turn(kBody.R * pose->fit.X_RB.R.transpose());
        Eigen::Matrix<double, 6, 1> error;
        error << kBody.p - pose->fit.X_RB.p, turn.angle() * turn.axis();
        sum += error.dot(pose->fit.covariance.inverse() * error) / kTimes;
      }
      EXPECT_LT(sum, 9.0) << noise_px << both;
      EXPECT_GT(sum, noise_px > 0.5 ? 3.0 : 0.3) << noise_px << both;
    }
  }
}

}  // namespace
}  // namespace dockyard
