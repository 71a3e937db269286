#include "controller/vision/stereo_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

/// Points rather than discs, as the closed forms have it: discs of 1 mm.
FiducialBoard PointBoard() {
  FiducialBoard board = TestBoard();
  board.disc_diameter_m = 1e-3;
  return board;
}
const FiducialBoard kBoard = PointBoard();

/// The board before the rover's cameras, face-on, at a distance from them.
Pose3 BoardAhead(double z_m, double yaw_rad = 0.0) {
  const StereoRig rig = TestRig(640, 480);
  return {.R = rig.X_RL.R * RotY(yaw_rad), .p = Eigen::Vector3d(rig.X_RL.p.x() + z_m, 0.0, 0.22)};
}

/// Centres of the projected discs in one camera, with noise.
std::vector<Eigen::Vector2d> Centres(const Camera& camera, const Pose3& X_RC, const Pose3& X_RB,
                                     double sigma_px, RandomStream& random) {
  std::vector<Eigen::Vector2d> centres;
  for (const Fiducial& fiducial : kBoard.fiducials) {
    centres.push_back(*ProjectDisc(camera, Inverse(X_RC) * X_RB, fiducial, kBoard.disc_diameter_m) +
                      sigma_px * Eigen::Vector2d(random.Normal(), random.Normal()));
  }
  return centres;
}

std::vector<MarkPixel> BothViews(const std::vector<Eigen::Vector2d>& left,
                                 const std::vector<Eigen::Vector2d>& right) {
  std::vector<MarkPixel> marks;
  for (int id = 0; id < 8; ++id) {
    marks.push_back({.id = id, .view = 0, .pixel = left[static_cast<std::size_t>(id)]});
    marks.push_back({.id = id, .view = 1, .pixel = right[static_cast<std::size_t>(id)]});
  }
  return marks;
}

struct Spread {
  double stereo_m = 0.0, joint_m = 0.0;  // RMS error of the range
};

/// Range errors over trials of the paper's fit and of the joint fit without the relative turn.
Spread MeasureSpread(const StereoRig& built, const StereoRig& believed, double z_m, double sigma_px,
                     int trials, bool fit_turn) {
  const Pose3 X_RB = BoardAhead(z_m);
  RefineOptions options;
  options.fit_turn = fit_turn;
  Spread sum;
  for (int i = 0; i < trials; ++i) {
    RandomStream random(StreamKey(static_cast<std::uint64_t>(i), "stereo noise"));
    const auto left = Centres(built.left, built.X_RL, X_RB, sigma_px, random);
    const auto right = Centres(built.right, built.X_RQ, X_RB, sigma_px, random);
    const auto stereo = StereoPose(believed, kBoard, left, right);
    const RefinedPose joint =
        RefinePose(BothViews(left, right), Views(believed), kBoard, *stereo, options);
    sum.stereo_m += std::pow(stereo->p.x() - X_RB.p.x(), 2);
    sum.joint_m += std::pow(joint.X_RB.p.x() - X_RB.p.x(), 2);
  }
  return {std::sqrt(sum.stereo_m / trials), std::sqrt(sum.joint_m / trials)};
}

StereoRig ToedIn(double yaw_rad) {
  StereoRig rig = TestRig(640, 480);
  rig.X_RQ.R = rig.X_RQ.R * RotY(yaw_rad);
  return rig;
}

TEST(Triangulation, FindsThePoint) {
  const StereoRig rig = TestRig(1024, 768);
  const Eigen::Vector3d p_R(3.1, -0.4, 0.5);
  const auto left = rig.left.Project(Inverse(rig.X_RL) * p_R);
  const auto right = rig.right.Project(Inverse(rig.X_RQ) * p_R);
  EXPECT_NEAR((*Triangulate(rig, *left, *right) - p_R).norm(), 0.0, 1e-9);
}

TEST(Triangulation, RefusesRaysThatMeetBehind) {
  const StereoRig rig = TestRig(1024, 768);
  EXPECT_FALSE(Triangulate(rig, {300.0, 384.0}, {700.0, 384.0}));
}

TEST(RigidFit, IsExactOnExactPoints) {
  const Pose3 X_AB{.R = RotZ(0.4) * RotY(-0.7), .p = {1.0, 2.0, -0.5}};
  std::vector<Eigen::Vector3d> points_B{{0, 0, 0}, {0.3, 0, 0}, {0, 0.2, 0}, {0.4, 0.5, 0}},
      points_A;
  for (const Eigen::Vector3d& p : points_B) points_A.push_back(X_AB * p);
  const auto fitted = FitRigid(points_B, points_A);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR((fitted->R - X_AB.R).norm() + (fitted->p - X_AB.p).norm(), 0.0, 1e-12);
}

TEST(RigidFit, RefusesPointsOnALine) {
  std::vector<Eigen::Vector3d> line{{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}};
  EXPECT_FALSE(FitRigid(line, line));
}

TEST(StereoPose, ObeysTheNoiseLawOfTriangulation) {
  // sigma_range = Z^2 sqrt(2) sigma / (f B sqrt(N)); 400 trials know a sigma to 3.5 %.
  const StereoRig rig = TestRig(640, 480);
  for (const double z : {2.0, 5.0}) {
    const double law =
        z * z * std::sqrt(2.0) * 0.1 / (rig.left.focal_px().x() * 0.35 * std::sqrt(8.0));
    const double measured = MeasureSpread(rig, rig, z, 0.1, 400, false).stereo_m;
    EXPECT_NEAR(measured / law, 1.0, 0.12) << "at " << z << " m";
  }
}

TEST(JointFit, HalvesTheNoiseOfTriangulation) {
  const StereoRig rig = TestRig(640, 480);
  const Spread spread = MeasureSpread(rig, rig, 5.0, 0.1, 200, false);
  EXPECT_GT(spread.stereo_m / spread.joint_m, 2.0);
}

TEST(StereoPose, IsBiasedByToeIn) {
  // bias = Z^2 d / B = 0.20 m at 5 m for 0.16 deg: the paper's figure (Tsai et al., V-E).
  const double bias = 25.0 * Radians(0.16) / 0.35;
  const StereoRig believed = TestRig(640, 480);
  const Spread spread = MeasureSpread(ToedIn(Radians(0.16)), believed, 5.0, 0.0, 1, false);
  EXPECT_NEAR(spread.stereo_m / bias, 1.0, 0.08);
}

TEST(JointFit, HalvesTheBiasOfToeInAtLeast) {
  // A board that seems too near may also be fitted turned, so that the two signs differ.
  const StereoRig believed = TestRig(640, 480);
  for (const double sign : {-1.0, 1.0}) {
    const StereoRig built = ToedIn(sign * Radians(0.16));
    const Spread spread = MeasureSpread(built, believed, 5.0, 0.1, 50, false);
    EXPECT_GT(spread.stereo_m / spread.joint_m, 2.0);
  }
}

TEST(JointFit, WithTheRelativeTurnCutsTheBiasOfToeInTenfold) {
  const StereoRig believed = TestRig(640, 480);
  for (const double sign : {-1.0, 1.0}) {
    const StereoRig built = ToedIn(sign * Radians(0.16));
    const Spread spread = MeasureSpread(built, believed, 5.0, 0.1, 50, true);
    EXPECT_GT(spread.stereo_m / spread.joint_m, 10.0);
  }
}

TEST(JointFit, ReadsTheToeInOffTheBoard) {
  const Pose3 X_RB = BoardAhead(1.5, Radians(20.0));
  const StereoRig built = ToedIn(Radians(0.16)), believed = TestRig(640, 480);
  RandomStream random(5);
  const auto left = Centres(built.left, built.X_RL, X_RB, 0.0, random);
  const auto right = Centres(built.right, built.X_RQ, X_RB, 0.0, random);
  const RefinedPose fit = RefinePose(BothViews(left, right), Views(believed), kBoard, X_RB);
  EXPECT_NEAR(fit.turn.mean_rad.y(), Radians(0.16), Radians(0.02));
}

TEST(JointFit, BringsAFarStartIn) {
  const StereoRig rig = TestRig(640, 480);
  const Pose3 X_RB = BoardAhead(3.0, Radians(25.0));
  RandomStream random(6);
  const auto left = Centres(rig.left, rig.X_RL, X_RB, 0.0, random);
  const auto right = Centres(rig.right, rig.X_RQ, X_RB, 0.0, random);
  const Pose3 start = BoardAhead(4.0, Radians(-5.0));
  const RefinedPose fit = RefinePose(BothViews(left, right), Views(rig), kBoard, start);
  EXPECT_NEAR((fit.X_RB.p - X_RB.p).norm(), 0.0, 1e-6);
  EXPECT_LT(fit.rms_px, 1e-5);
}

TEST(JointFit, IsNotDraggedAwayByOneFalseMark) {
  const StereoRig rig = TestRig(640, 480);
  const Pose3 X_RB = BoardAhead(2.0);
  RandomStream random(7);
  auto left = Centres(rig.left, rig.X_RL, X_RB, 0.05, random);
  const auto right = Centres(rig.right, rig.X_RQ, X_RB, 0.05, random);
  left[3].x() += 15.0;
  const RefinedPose fit = RefinePose(BothViews(left, right), Views(rig), kBoard, X_RB);
  EXPECT_LT((fit.X_RB.p - X_RB.p).norm(), 0.03);
}

TEST(ProjectedDisc, IsOffItsCentreByTheEccentricityFormula) {
  // f (R/Z)^2 sin t cos t = 0.440 px at f = 407.4, R = 5 cm, Z = 1 m, t = 30 deg.
  const Camera camera = EquidistantCamera(640, 480, Radians(90.0));
  const Pose3 X_CB{.R = RotY(Radians(30.0)), .p = {0.0, 0.0, 1.0}};
  const auto disc = ProjectDisc(camera, X_CB, Fiducial{}, 0.10);
  const auto centre = camera.Project(X_CB.p);
  EXPECT_NEAR((*disc - *centre).norm(), 0.440, 0.01);
}

}  // namespace
}  // namespace dockyard
