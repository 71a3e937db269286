#include "controller/vision/points/point_pose.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "controller/vision/p3p.h"
#include "controller/vision/points/point_acceptance.h"
#include "controller/vision/points/point_fit.h"
#include "sim/base/random.h"
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
  // The calibration, which is sought too, moves the other minimum by 0.5 deg.
  EXPECT_GT(pose->other_RB->R.col(0).dot(mirrored), std::cos(Radians(6.0)));
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
  // Noise alone: no calibration spread in the world, so the stated sigma may not be below the
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

/// Both images of the points as they are, with places as surveyed: off by survey_m, 1 sigma.
std::vector<PointPixel> Surveyed(double survey_m, double noise_px, std::uint64_t seed) {
  RandomStream random(1000 + seed);
  std::vector<Eigen::Vector3d> truth = Solid();
  for (int i = 0; i < 4; ++i)
    truth.push_back(0.8 * truth[static_cast<std::size_t>(i)] + Eigen::Vector3d(0.02, 0.1, -0.05));
  std::vector<PointPixel> seen = Seen(truth, true, true, noise_px, seed);
  for (std::size_t i = 0; i < seen.size(); i += 2) {
    const Eigen::Vector3d off(random.Normal(), random.Normal(), random.Normal());
    for (std::size_t k : {i, i + 1}) seen[k].p_B += survey_m * off;
  }
  return seen;
}

/// Square of the error over the covariance, six degrees of freedom.
double SquaredError(const RefinedPose& fit) {
  const Eigen::AngleAxisd turn(kBody.R * fit.X_RB.R.transpose());
  Eigen::Matrix<double, 6, 1> error;
  error << kBody.p - fit.X_RB.p, turn.angle() * turn.axis();
  return error.dot(fit.covariance.inverse() * error);
}

TEST(PointPose, BadlySurveyedPointsAreKeptAndTheCovarianceTells) {
  // 1 cm is 3 px here, 20 times the pixels' noise.
  double sum = 0.0;
  int used = 0, all = 0;
  constexpr int kTimes = 100;
  for (int i = 0; i < kTimes; ++i) {
    const auto seen = Surveyed(0.01, 0.15, static_cast<std::uint64_t>(i + 1));
    const auto pose = PoseFromPoints(seen, kRig, {}, {.survey_m = 0.01});
    ASSERT_TRUE(pose);
    sum += SquaredError(pose->fit) / kTimes;
    for (const bool inlier : pose->inlier) used += inlier;
    all += static_cast<int>(seen.size());
  }
  EXPECT_GT(used, 0.995 * all);
  EXPECT_GT(sum, 2.0);  // 6 when the covariance is right; the calibration's part is not drawn here
  EXPECT_LT(sum, 9.0);
}

TEST(PointPose, APointsTwoPixelsShareItsSurveyError) {
  // Noise of 3 px that both pixels of a point share carries less information than independent noise
  // in each: the place across the view is known as by one camera, not by two.
  const auto seen = Surveyed(0.0, 0.0, 1);
  PointFitOptions shared{.sigma_px = 0.15, .survey_m = 0.01, .survey_share = 1.0};
  const std::vector<bool> all(seen.size(), true);
  std::vector<bool> left(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) left[i] = seen[i].view == 0;
  PointEstimate start;
  start.pose.X_RB = kBody;
  const std::vector<CameraView> views{{kRig.left, kRig.X_RL}, {kRig.right, kRig.X_RQ}};
  const auto turn_about_view = [&](const std::vector<bool>& chosen, bool turn) {
    shared.fit_turn = turn;
    return std::sqrt(FitPoints(seen, chosen, views, start, shared).fit.covariance(3, 3));
  };
  const double one = turn_about_view(left, false), two = turn_about_view(all, true);
  EXPECT_NEAR(two / one, 1.0, 0.06);  // 0.71 if each pixel had its own
}

TEST(PointPose, AgreesWithTheDenseCovarianceOfAllPixels) {
  // The same pose by generalised least squares on the whole covariance matrix of the pixels,
  // derivatives by differences: nothing eliminated. Calibration and turn are part of that matrix.
  // Survey errors of 2 mm: beyond, the second order parts the two.
  const auto seen = Surveyed(0.002, 0.15, 5);
  const std::vector<CameraView> views{{kRig.left, kRig.X_RL}, {kRig.right, kRig.X_RQ}};
  PointEstimate start;
  start.pose.X_RB = kBody;
  const PointFitOptions options{.sigma_px = 0.5, .survey_m = 0.004, .fit_turn = true};
  const PointFit fit = FitPoints(seen, std::vector<bool>(seen.size(), true), views, start, options);
  const auto rows = static_cast<Eigen::Index>(2 * seen.size());
  const RefineOptions refine;
  const auto errors = [&](const PoseEstimate& at) {
    const PoseProblem problem(seen, views, refine);
    Eigen::VectorXd e(rows);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      e.segment<2>(2 * static_cast<Eigen::Index>(i)) = problem.Errors(at)[i];
    }
    return e;
  };
  PoseEstimate at{.X_RB = kBody};
  for (int round = 0; round < 10; ++round) {
    Eigen::MatrixXd J(rows, 9);
    for (int k = 0; k < 9; ++k) {
      const PoseStep step = 1e-6 * PoseStep::Unit(k);
      J.col(k) = (errors(Moved(at, step)) - errors(Moved(at, -step))) / 2e-6;
    }
    Eigen::MatrixXd S = 0.25 * Eigen::MatrixXd::Identity(rows, rows);
    const PoseProblem problem(seen, views, refine);
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(rows, 8);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(2 * i);
      C.block<2, 4>(row, 4 * seen[i].view) = refine.sigma_px * problem.Rows(at, i).by_calibration;
      for (std::size_t k = 0; k < seen.size(); ++k) {
        if (seen[k].p_B != seen[i].p_B) continue;  // a shift of the point is one of the body in R
        S.block<2, 2>(row, static_cast<Eigen::Index>(2 * k)) +=
            1.6e-5 * J.block<2, 3>(row, 3) *
            J.block<2, 3>(static_cast<Eigen::Index>(2 * k), 3).transpose();
      }
    }
    S += C * C.transpose();
    const Eigen::MatrixXd W = S.inverse();
    Eigen::Matrix<double, 9, 9> A = J.transpose() * W * J;
    PoseStep b = J.transpose() * W * errors(at);
    const Eigen::Matrix3d prior = refine.turn.covariance.inverse();
    A.bottomRightCorner<3, 3>() += prior;
    b.tail<3>() += prior * at.turn_rad;
    at = Moved(at, -A.ldlt().solve(b));
  }
  const double sigma_m = std::sqrt(fit.fit.covariance.topLeftCorner<3, 3>().trace());
  EXPECT_LT((at.X_RB.p - fit.fit.X_RB.p).norm(), 0.03 * sigma_m);
  const double sigma_rad = std::sqrt(fit.fit.covariance.bottomRightCorner<3, 3>().trace());
  EXPECT_LT(Eigen::AngleAxisd(at.X_RB.R.transpose() * fit.fit.X_RB.R).angle(), 0.03 * sigma_rad);
}

TEST(PointPose, WrongNamesGiveNoPose) {
  RandomStream random(11);
  int poses = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<PointPixel> seen = Surveyed(0.005, 0.15, static_cast<std::uint64_t>(i + 1));
    const std::vector<PointPixel> right = seen;
    const std::size_t n = seen.size() / 2;
    const auto by = static_cast<std::size_t>(random.Uniform(1.0, static_cast<double>(n) - 1e-9));
    const std::size_t step = i % 2 == 0 ? 5 : 7;  // prime to the 12 points
    for (std::size_t k = 0; k < seen.size(); ++k) {
      seen[k].p_B = right[2 * ((step * (k / 2) + by) % n) + k % 2].p_B;
    }
    if (PoseFromPoints(seen, kRig, {}, {.survey_m = 0.005})) ++poses;
  }
  EXPECT_LE(poses, 1);
}

TEST(PointPose, AccidentsAreCountedAsTheClosedFormHasThem) {
  // Seven points of one image in a box of 400 x 300 px, five of them within 5 px: 35 triples of
  // four poses each, and two or more of the four others in a circle of that radius.
  std::vector<PointPixel> points(7);
  const std::vector<bool> inlier{true, true, true, true, true, false, false};
  for (int i = 0; i < 7; ++i) {
    points[static_cast<std::size_t>(i)].p_B.x() = i;
    points[static_cast<std::size_t>(i)].pixel = {400.0 * (i % 2), 50.0 * i};
  }
  const double p = kPi * 25.0 / (400.0 * 300.0), q = 1.0 - p;
  const double tail = 6.0 * p * p * q * q + 4.0 * p * p * p * q + p * p * p * p;
  EXPECT_NEAR(ExpectedAccidents(points, inlier, {1, 5, 2, 3, 0, 90, 80}) / (4.0 * 35.0 * tail), 1.0,
              1e-9);
}

TEST(PointPose, NeedsFourPointsHoweverManyPixels) {
  for (const std::size_t pixels : {4u, 6u}) {  // two and three points, each in both images
    std::vector<PointPixel> seen = Seen(Solid(), true, true, 0.0);
    seen.resize(pixels);
    const auto pose = PoseFromPoints(seen, kRig, {});
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error(), PoseFailure::kTooFewFiducials);
  }
}

TEST(PointPose, PointsOnALineFixNoPose) {
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 6; ++i) line.emplace_back(0.0, 0.15 * i - 0.4, 1e-5 * i * i);
  EXPECT_FALSE(PoseFromPoints(Seen(line, true, true, 0.0), kRig, {}));
  EXPECT_FALSE(PoseFromPoints(Seen(line, true, true, 0.2), kRig, {}, {.survey_m = 0.001}));
}

TEST(PointPose, ExchangedCamerasAreNoticed) {
  std::vector<PointPixel> seen = Seen(Solid(), true, true, 0.1);
  for (PointPixel& point : seen) point.view = 1 - point.view;
  const auto pose = PoseFromPoints(seen, kRig, {});
  ASSERT_FALSE(pose);
  EXPECT_EQ(pose.error(), PoseFailure::kCamerasDisagree);
}

TEST(PointPose, DiscsAreComparedWithTheMiddleOfTheirEllipse) {
  // 0.3 m across at 2.4 m, tilted: the ellipse's middle is off the centre's image.
  const Pose3 X_LB = Inverse(kRig.X_RL) * kBody, X_QB = Inverse(kRig.X_RQ) * kBody;
  std::vector<PointPixel> seen = Seen(Solid(), true, true, 0.0);
  double most = 0.0;
  for (PointPixel& point : seen) {
    point.disc_diameter_m = 0.3;
    const Camera& camera = point.view == 0 ? kRig.left : kRig.right;
    const auto middle = ProjectDisc(camera, point.view == 0 ? X_LB : X_QB, point.p_B, 0.3);
    most = std::max(most, (*middle - point.pixel).norm());
    point.pixel = *middle;
  }
  EXPECT_GT(most, 0.5);
  const auto pose = PoseFromPoints(seen, kRig, {});
  ASSERT_TRUE(pose);
  for (const bool inlier : pose->inlier) EXPECT_TRUE(inlier);
  ExpectNear(pose->fit.X_RB, 1e-4, 1e-4);
}

}  // namespace
}  // namespace dockyard
