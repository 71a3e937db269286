// Boards that are bowed, and marks that do not belong: how far the noise is raised, and when not.
#include "controller/vision/board/noise_raise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/vision/board/pose_gates.h"
#include "controller/vision/stereo_pose.h"
#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

constexpr double kSigma = 0.03;  // of a mark's centre [px]

/// OpenCV's asymmetric grid of 4 x 11 on A4.
FiducialBoard AsymmetricGrid() {
  FiducialBoard board{.width_m = 0.18,
                      .height_m = 0.235,
                      .disc_diameter_m = 0.015,
                      .bar_length_m = 0.0,
                      .bar_width_m = 0.0,
                      .fiducials = {},
                      .upright = {}};
  board.upright = {.against = Upright::Against::kImage, .within_rad = kPi};
  for (int row = 0; row < 11; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double shift = row % 2 == 1 ? 0.02 : 0.0;
      board.fiducials.push_back({.p_BF = {column * 0.04 + shift - 0.07, (row - 5) * 0.02}});
    }
  }
  return board;
}

/// A parabolic bow across x or y, its mean height zero.
double Bow(const FiducialBoard& board, const Eigen::Vector2d& p, double height_m, bool across_x) {
  const double share = 2.0 * (across_x ? p.x() / board.width_m : p.y() / board.height_m);
  return height_m * (1.0 / 3.0 - share * share);
}

class NoiseRaise : public ::testing::Test {
 protected:
  /// The marks of one view when they lie off the plane by `off_m(p_BF)`.
  template <class Off>
  std::vector<MarkPixel> Marks(const FiducialBoard& board, const Pose3& X_RB, int view, Off off_m) {
    std::vector<MarkPixel> marks;
    const Pose3 X_CB = Inverse(views_[static_cast<std::size_t>(view)].X_RC) * X_RB;
    for (std::size_t id = 0; id < board.fiducials.size(); ++id) {
      const Eigen::Vector2d& p = board.fiducials[id].p_BF;
      const Eigen::Vector3d p_B(p.x(), p.y(), off_m(p));
      const auto pixel = ProjectDisc(camera_, X_CB, p_B, board.disc_diameter_m);
      const Eigen::Vector2d noise(random_.Normal(), random_.Normal());
      marks.push_back({.id = static_cast<int>(id),
                       .view = view,
                       .pixel = *pixel + kSigma * noise,
                       .sigma_px = kSigma});
    }
    return marks;
  }
  FitInputs Inputs(const FiducialBoard& board) const {
    return {.views = views_, .board = board, .refine = {}};
  }
  static Fix At(const Pose3& X_RB, const std::vector<MarkPixel>& marks, const char* method) {
    return {.fit = {.X_RB = X_RB}, .marks = marks, .method = method};
  }

  RandomStream random_{StreamKey(11, "noise raise")};
  Camera camera_ = EquidistantCamera(800, 600, Radians(65.0));
  std::vector<CameraView> views_{{camera_, Pose3{}},
                                 {camera_, {Eigen::Matrix3d::Identity(), {0.12, 0.0, 0.0}}}};
};

TEST_F(NoiseRaise, ABowedBoardIsLocatedWithinItsSigmas) {
  const FiducialBoard board = AsymmetricGrid();
  int refused = 0;
  double most_sigmas = 0.0;
  for (const double height_m : {0.002, 0.003, -0.002, -0.003}) {
    for (int i = 0; i < 6; ++i) {
      const Pose3 X_RB{RotY(0.5 * std::cos(i)) * RotX(0.5 * std::sin(i)) * RotZ(0.4 * i),
                       {0.02, -0.01, 0.5}};
      const auto marks = Marks(board, X_RB, 0, [&](const Eigen::Vector2d& p) {
        return Bow(board, p, height_m, i % 2 == 0);
      });
      const FitInputs inputs = Inputs(board);
      const Fix start = At(X_RB, marks, "left");
      refused +=
          Judge(WithoutStrays(inputs, start).fit, {views_[0]}, {}, board.upright).has_value();
      const RaisedFix raised = WithNoiseRaised(inputs, start);
      EXPECT_FALSE(raised.failure) << height_m << " " << i;
      const Eigen::Vector3d error_m = raised.fix.fit.X_RB.p - X_RB.p;
      EXPECT_LT(error_m.norm(), 0.006);
      for (int k = 0; k < 3; ++k) {
        most_sigmas = std::max(most_sigmas,
                               std::abs(error_m(k)) / std::sqrt(raised.fix.fit.covariance(k, k)));
      }
    }
  }
  EXPECT_EQ(refused, 24);  // by the prediction alone
  EXPECT_LT(most_sigmas, 3.0);
}

TEST_F(NoiseRaise, AFlatBoardKeepsItsPredictedCovariance) {
  const FiducialBoard board = AsymmetricGrid();
  const Pose3 X_RB{RotY(0.3) * RotX(-0.2), {0.02, -0.01, 0.5}};
  // Noise of the whole prediction, model's part included.
  std::vector<MarkPixel> marks = Marks(board, X_RB, 0, [](const Eigen::Vector2d&) { return 0.0; });
  for (MarkPixel& mark : marks) {
    mark.pixel += RefineOptions{}.model_px * Eigen::Vector2d(random_.Normal(), random_.Normal());
  }
  const Fix start = At(X_RB, marks, "left");
  const RaisedFix raised = WithNoiseRaised(Inputs(board), start);
  EXPECT_FALSE(raised.failure);
  const Fix predicted = WithoutStrays(Inputs(board), start);
  EXPECT_NEAR(raised.fix.fit.covariance.trace() / predicted.fit.covariance.trace(), 1.0, 0.2);
}

TEST_F(NoiseRaise, AStatedBowIsPartOfThePrediction) {
  const FiducialBoard board = AsymmetricGrid();
  const Pose3 X_RB{RotY(0.4), {0.02, -0.01, 0.5}};
  const auto marks =
      Marks(board, X_RB, 0, [&](const Eigen::Vector2d& p) { return Bow(board, p, 0.002, true); });
  FitInputs inputs = Inputs(board);
  EXPECT_TRUE(
      Judge(WithoutStrays(inputs, At(X_RB, marks, "left")).fit, {views_[0]}, {}, board.upright));
  inputs.refine.off_plane_m = 0.3 * 0.002;
  EXPECT_FALSE(
      Judge(WithoutStrays(inputs, At(X_RB, marks, "left")).fit, {views_[0]}, {}, board.upright));
}

TEST_F(NoiseRaise, MarksThatDisagreeInKindAreRefused) {
  const FiducialBoard board = AsymmetricGrid();
  const Pose3 X_RB{RotY(0.3), {0.02, -0.01, 0.5}};
  const auto marks = Marks(board, X_RB, 0, [](const Eigen::Vector2d&) { return 0.0; });
  ASSERT_EQ(marks.size(), 44u);
  // At most a third may be left out.
  for (const int wrong : {10, 18}) {
    auto some = marks;
    for (int i = 0; i < wrong; ++i) {
      const double angle = 2.4 * i;
      some[static_cast<std::size_t>(2 * i)].pixel +=
          1.5 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    const RaisedFix raised = WithNoiseRaised(Inputs(board), At(X_RB, some, "left"));
    EXPECT_EQ(raised.failure.has_value(), wrong > 14) << wrong;
    if (wrong > 14) continue;
    EXPECT_EQ(raised.fix.marks.size(), marks.size() - static_cast<std::size_t>(wrong));
  }
}

TEST_F(NoiseRaise, FewMarksMustFitAsPredicted) {
  // The chance that a wrong match fits so well is the same for any number of marks.
  for (const int freedom : {4, 6, 8, 10}) {
    EXPECT_NEAR(freedom * std::log(MostRaisedRmsPx(freedom) / 2.5), 4.0 * std::log(0.12 / 2.5),
                1e-9);
  }
  EXPECT_EQ(MostRaisedRmsPx(82), 1.0);
  const FiducialBoard board = TestBoard();
  const Pose3 X_RB{RotY(0.3), {0.1, 0.0, 2.0}};
  auto marks = Marks(board, X_RB, 0, [](const Eigen::Vector2d&) { return 0.0; });
  marks.resize(5);
  for (MarkPixel& mark : marks) {
    mark.pixel += 0.6 * Eigen::Vector2d(random_.Normal(), random_.Normal());
  }
  const RaisedFix raised = WithNoiseRaised(Inputs(board), At(X_RB, marks, "left"));
  EXPECT_EQ(raised.failure, PoseFailure::kPoorFit);
}

TEST_F(NoiseRaise, ImagesThatFitByThemselvesAloneAreRefused) {
  const FiducialBoard board = AsymmetricGrid();
  const Pose3 X_RB{RotY(0.3), {0.02, -0.01, 0.5}};
  const auto flat = [](const Eigen::Vector2d&) { return 0.0; };
  auto marks = Marks(board, X_RB, 0, flat);
  // The board was tilted between the two images: no turn of the cameras has this effect.
  const Pose3 moved = X_RB * Pose3{RotY(0.08), Eigen::Vector3d::Zero()};
  for (const MarkPixel& mark : Marks(board, moved, 1, flat)) marks.push_back(mark);
  const RaisedFix raised = WithNoiseRaised(Inputs(board), At(X_RB, marks, "stereo"));
  EXPECT_EQ(raised.failure, PoseFailure::kCamerasDisagree);
}

}  // namespace
}  // namespace dockyard
