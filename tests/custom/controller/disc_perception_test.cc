#include <gtest/gtest.h>

#include <cmath>

#include "controller/custom/sighting.h"
#include "custom/controller/test_robot.h"

namespace dockyard::custom {
namespace {

/// The board's albedo at a point of its plane; grey off the plate.
double Shade(const FiducialBoard& board, const Eigen::Vector2d& p_B) {
  if (std::abs(p_B.x()) > 0.5 * board.width_m || std::abs(p_B.y()) > 0.5 * board.height_m)
    return 110.0;
  for (const Fiducial& mark : board.fiducials) {
    if ((p_B - mark.p_BF).norm() < 0.5 * board.disc_diameter_m) return 20.0;
  }
  return 220.0;
}

/// Each pixel as the mean of 25 rays.
GrayImage Draw(const Camera& camera, const Pose3& X_CB, const FiducialBoard& board) {
  GrayImage image{camera.width, camera.height, {}};
  const Pose3 X_BC = Inverse(X_CB);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      double sum = 0.0;
      for (int k = 0; k < 25; ++k) {
        const Eigen::Vector2d pixel(u - 0.4 + 0.2 * (k % 5), v - 0.4 + 0.2 * (k / 5));
        const Eigen::Vector3d sight_B = X_BC.R * camera.Direction(pixel);
        const double t = -X_BC.p.z() / sight_B.z();
        const Eigen::Vector3d hit = X_BC.p + t * sight_B;
        sum += t > 0.0 ? Shade(board, hit.head<2>()) : 110.0;
      }
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(sum / 25.0)));
    }
  }
  return image;
}

TEST(PerceiveDiscs, GivesThePoseOfADrawnBoardAsOneOfItsBranches) {
  Nominal nominal = NominalOf();
  nominal.cameras[0].camera = EquidistantCamera(320, 240, Radians(40.0));
  nominal.boards[0].board.upright = {Upright::Against::kGravity, Radians(30.0)};
  const auto perceive = PerceiveDiscs(nominal);
  ASSERT_TRUE(perceive);
  const Pose3 X_DR = FromGround({0.75, 0.12, -2.95}, 0.0);
  const Pose3 X_CB = Inverse(X_DR * nominal.cameras[0].X_RC) * nominal.boards[0].X_DB;
  const CameraImage image{0, Draw(nominal.cameras[0].camera, X_CB, nominal.boards[0].board), 40,
                          0.0};
  const auto sightings = (*perceive)(image, Eigen::Vector3d::UnitZ());
  ASSERT_EQ(sightings.size(), 1u);
  const BoardSighting& sighting = sightings[0];
  ASSERT_FALSE(sighting.branches.empty()) << sighting.failure << " of " << sighting.detected;
  EXPECT_EQ(sighting.exposed, 40);
  EXPECT_EQ(sighting.marks.size(), 9u);
  double nearest = 1e9;
  for (const PoseBranch& branch : sighting.branches) {
    Eigen::Matrix<double, 6, 1> error;
    const Eigen::AngleAxisd turn(branch.X_CB.R * X_CB.R.transpose());
    error << branch.X_CB.p - X_CB.p, turn.angle() * turn.axis();
    nearest = std::min(nearest, error.dot(branch.covariance.inverse() * error));
  }
  EXPECT_LT(nearest, 22.5);  // chi-square, 6 degrees of freedom, 99.9 %
}

// The tag is not in the image.
TEST(PerceiveMarks, LocatesABoardOfDiscsNextToOneOfTagsByItsOwnNumber) {
  Nominal nominal = NominalOf();
  nominal.cameras[0].camera = EquidistantCamera(320, 240, Radians(40.0));
  nominal.boards[0].board.upright = {Upright::Against::kGravity, Radians(30.0)};
  const DockBoard discs = nominal.boards[0];
  DockBoard tags = discs;
  tags.name = "tags";
  tags.board.fiducials.clear();
  tags.board.tags = {{.family = "tag36h11", .id = 7, .size_m = 0.1}};
  const Pose3 X_DR = FromGround({0.75, 0.12, -2.95}, 0.0);
  const Pose3 X_CB = Inverse(X_DR * nominal.cameras[0].X_RC) * discs.X_DB;
  const CameraImage image{0, Draw(nominal.cameras[0].camera, X_CB, discs.board), 40, 0.0};
  const auto alone = (*PerceiveDiscs(nominal))(image, Eigen::Vector3d::UnitZ());
  nominal.boards = {tags, discs};
  const auto sightings = (*PerceiveMarks(nominal))(image, Eigen::Vector3d::UnitZ());
  ASSERT_EQ(sightings.size(), 2u);
  EXPECT_EQ(sightings[0].board, 0);
  EXPECT_EQ(sightings[0].failure, "no tag of the board");
  EXPECT_EQ(sightings[1].board, 1);
  ASSERT_FALSE(sightings[1].branches.empty());
  EXPECT_EQ(sightings[1].branches[0].X_CB.p, alone[0].branches[0].X_CB.p);
}

TEST(PerceiveDiscs, OfAnEmptyImageSaysWhyThereIsNoPose) {
  const Nominal nominal = NominalOf();
  const CameraImage image{0, GrayImage{64, 48, std::vector<std::uint8_t>(64 * 48, 90)}, 0, 0.0};
  const auto sightings = (*PerceiveDiscs(nominal))(image, Eigen::Vector3d::UnitZ());
  ASSERT_EQ(sightings.size(), 1u);
  EXPECT_TRUE(sightings[0].branches.empty());
  EXPECT_FALSE(sightings[0].failure.empty());
}

TEST(GreyOf, IsTheLuminanceOfColours) {
  const CameraImage image{0, RgbImage{2, 1, {255, 0, 0, 10, 20, 30}}, 0, 0.0};
  const GrayImage grey = GreyOf(image);
  EXPECT_EQ(grey.width, 2);
  EXPECT_EQ(grey.pixels, (std::vector<std::uint8_t>{76, 18}));  // 76.245, 18.15
}

}  // namespace
}  // namespace dockyard::custom
