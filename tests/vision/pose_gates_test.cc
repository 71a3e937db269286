// Checks of a pose against its own predicted error: the distribution, and what is refused.
#include "controller/vision/board/pose_gates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/vision/stereo_pose.h"
#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

const FiducialBoard kBoard = TestBoard();
constexpr double kSigma = 0.03;  // of a mark's centre [px]

Pose3 BoardAt(double r_m, double alpha_deg, double h_deg) {
  return Inverse(RoverAt({r_m, Radians(alpha_deg), Radians(h_deg)}, 0.0)) * TestBoardInDock();
}

const LocateHints kLevel{};

/// A rig off its calibration by one draw from RefineOptions, except the pair's mounting.
StereoRig Built(StereoRig rig, RandomStream& random) {
  const CalibrationSpread spread;
  const CameraTurn turn;
  Eigen::Vector3d w;
  for (int i = 0; i < 3; ++i) w(i) = std::sqrt(turn.covariance(i, i)) * random.Normal();
  const Eigen::Matrix3d half = Eigen::AngleAxisd(0.5 * w.norm(), w.normalized()).matrix();
  rig.X_RL.R = rig.X_RL.R * half.transpose();
  rig.X_RQ.R = rig.X_RQ.R * half;
  for (Camera* camera : {&rig.left, &rig.right}) {
    const Eigen::Vector2d shift(random.Normal(), random.Normal());
    *camera =
        Bent(Adjusted(*camera, 1.0 + spread.focal * random.Normal(), spread.centre_px * shift),
             spread.radial_px * random.Normal());
  }
  return rig;
}

/// Every fiducial in both images, off by noise of the predicted sigma, model's part included.
std::vector<MarkPixel> NoisyMarks(const StereoRig& built, const Pose3& X_RB, RandomStream& random) {
  const double sigma = std::hypot(kSigma, RefineOptions{}.model_px);
  std::vector<MarkPixel> marks;
  for (int view = 0; view < 2; ++view) {
    const Camera& camera = view == 0 ? built.left : built.right;
    const Pose3 X_CB = Inverse(view == 0 ? built.X_RL : built.X_RQ) * X_RB;
    for (int id = 0; id < static_cast<int>(kBoard.fiducials.size()); ++id) {
      const auto pixel = ProjectDisc(camera, X_CB, kBoard.fiducials[static_cast<std::size_t>(id)],
                                     kBoard.disc_diameter_m);
      const Eigen::Vector2d noise(random.Normal(), random.Normal());
      marks.push_back(
          {.id = id, .view = view, .pixel = *pixel + sigma * noise, .sigma_px = kSigma});
    }
  }
  return marks;
}

TEST(ChiSquareLimit, IsTheTabulatedQuantile) {
  // Abramowitz and Stegun, table 26.8, Q = 0.001.
  EXPECT_NEAR(ChiSquareLimit(4), 18.467, 0.30);
  EXPECT_NEAR(ChiSquareLimit(10), 29.588, 0.20);
  EXPECT_NEAR(ChiSquareLimit(26), 54.052, 0.15);
}

TEST(PoseGate, RightPosesPassAtTheNominalRate) {
  // Noise and calibration as believed: the misfit must be chi-square, so that one in a thousand is
  // refused. Mean and variance tell more than the few that are.
  const StereoRig rig = TestRig(1024, 768);
  RandomStream random(StreamKey(7, "gate"));
  constexpr int kCount = 600;
  double sum = 0.0, squares = 0.0;
  int refused = 0, freedom = 0;
  for (int i = 0; i < kCount; ++i) {
    const Pose3 X_RB =
        BoardAt(random.Uniform(1.5, 6.0), random.Uniform(-35, 35), random.Uniform(-15, 15));
    const auto marks = NoisyMarks(Built(rig, random), X_RB, random);
    const RefinedPose fit = RefinePose(marks, Views(rig), kBoard, X_RB);
    freedom = fit.freedom;
    sum += fit.misfit;
    squares += fit.misfit * fit.misfit;
    refused += Judge(fit, Views(rig), kLevel).has_value();
  }
  ASSERT_EQ(freedom, 26);
  const double mean = sum / kCount, variance = squares / kCount - mean * mean;
  EXPECT_NEAR(mean, 26.0, 4.0 * std::sqrt(2.0 * 26.0 / kCount));
  EXPECT_NEAR(variance, 52.0, 0.25 * 52.0);
  EXPECT_LE(refused, 4);  // 0.6 expected
}

TEST(PoseGate, RefusesEveryNamingWithTwoNamesChanged) {
  const StereoRig rig = TestRig(1024, 768);
  RandomStream random(StreamKey(8, "gate"));
  for (const double r_m : {2.0, 4.0, 6.0}) {
    const Pose3 X_RB = BoardAt(r_m, 10.0, 0.0);
    const auto right = NoisyMarks(Built(rig, random), X_RB, random);
    ASSERT_FALSE(Judge(RefinePose(right, Views(rig), kBoard, X_RB), Views(rig), kLevel));
    for (int a = 0; a < 8; ++a) {
      for (int b = a + 1; b < 8; ++b) {
        auto marks = right;
        for (MarkPixel& mark : marks) mark.id = mark.id == a ? b : mark.id == b ? a : mark.id;
        const RefinedPose fit = RefinePose(marks, Views(rig), kBoard, X_RB);
        EXPECT_TRUE(Judge(fit, Views(rig), kLevel)) << a << " and " << b << " at " << r_m << " m";
      }
    }
  }
}

TEST(PoseGate, TellsTheFalseMarkAmongTheRightOnes) {
  // One pixel off: the pose before this gate passed it up to 2 px rms over all marks.
  const StereoRig rig = TestRig(1024, 768);
  RandomStream random(StreamKey(9, "gate"));
  const Pose3 X_RB = BoardAt(4.0, 10.0, 0.0);
  const auto right = NoisyMarks(Built(rig, random), X_RB, random);
  for (std::size_t i = 0; i < right.size(); ++i) {
    auto marks = right;
    marks[i].pixel += Eigen::Vector2d(0.8, -0.6);
    const RefinedPose fit = RefinePose(marks, Views(rig), kBoard, X_RB);
    const auto worst = std::max_element(fit.mark_sigmas.begin(), fit.mark_sigmas.end());
    EXPECT_EQ(static_cast<std::size_t>(worst - fit.mark_sigmas.begin()), i);
    EXPECT_GT(*worst, 4.5);
    EXPECT_EQ(Judge(fit, Views(rig), kLevel), PoseFailure::kCamerasDisagree);
  }
}

// 0.2 deg about the vertical is one sigma of a calibration (pose_refine.h).
TEST(PoseGate, TakesCamerasTurnedByFourAndAHalfSigmaAndNoneBySix) {
  const StereoRig rig = TestRig(1024, 768);
  const Pose3 X_RB = BoardAt(3.0, 10.0, 0.0);
  for (const double sigmas : {-6.0, -4.5, 4.5, 6.0}) {
    RandomStream random(StreamKey(11, "gate"));
    StereoRig built = rig;
    built.X_RQ.R = built.X_RQ.R * RotY(sigmas * std::sqrt(1.2e-5));
    const RefinedPose fit = RefinePose(NoisyMarks(built, X_RB, random), Views(rig), kBoard, X_RB);
    const auto failure = Judge(fit, Views(rig), kLevel);
    EXPECT_EQ(failure.has_value(), std::abs(sigmas) > 5.0) << sigmas;
    if (!failure) {
      EXPECT_LT((fit.X_RB.p - X_RB.p).norm(), 0.03) << sigmas;
    }
  }
}

TEST(PoseGate, RefusesAPoseThatItselfCallsUseless) {
  const StereoRig rig = TestRig(1024, 768);
  RandomStream random(StreamKey(10, "gate"));
  const Pose3 X_RB = BoardAt(4.0, 10.0, 0.0);
  RefinedPose fit = RefinePose(NoisyMarks(rig, X_RB, random), Views(rig), kBoard, X_RB);
  ASSERT_FALSE(Judge(fit, Views(rig), kLevel));
  RefinedPose far = fit, turned = fit;
  far.covariance(0, 0) = 0.12 * 0.12;
  turned.covariance(5, 5) = Radians(4.0) * Radians(4.0);
  EXPECT_EQ(Judge(far, Views(rig), kLevel), PoseFailure::kUncertain);
  EXPECT_EQ(Judge(turned, Views(rig), kLevel), PoseFailure::kUncertain);
}

}  // namespace
}  // namespace dockyard
