#include "controller/rocky7/face_belief.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/motion/arcs.h"
#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

const Eigen::Vector3d kPoint(3.0, 0.4, 0.35);

FaceBelief Believed() {
  FaceBelief belief;
  belief.begun = true;
  belief.p_ET = kPoint;
  belief.normal_E = Eigen::Vector3d(-0.8, 0.0, 0.6);
  belief.normal_sigma_rad = Radians(2.0);
  belief.obstacles_E = {{3.2, 0.4}, {3.2, 0.6}};
  return belief;
}

// A view without disparities: it shows no obstacles.
FaceView BlindView(const Nominal& nominal) {
  FaceView view;
  view.X_ER = LevelFrame(nominal, {});
  view.X_EK = view.X_ER * SecondLink(nominal.mast, nominal.mast.watch_rad);
  view.pair.X_RC = view.X_EK;
  return view;
}

FaceSighting Sighted(const Eigen::Vector3d& p_E, const Eigen::Vector3d& normal_E, double sigma) {
  return {.found = true, .p_E = p_E, .normal_E = normal_E, .normal_sigma_rad = sigma};
}

TEST(FaceBelief, MovesWithTheRoverAsARigidScene) {
  FaceBelief belief = Believed();
  Pose2 X_WR;
  for (const Arc& arc : {Arc{0.4, 0.2}, Arc{-0.1, 0.0}, Arc{0.3, -0.5}}) {
    const Pose2 since = Advance({}, arc);
    X_WR = X_WR * since;
    MoveOn(since, arc.length_m, Eigen::Vector2d(0.0, 0.0), belief);
  }
  const Pose3 X_RW = Inverse(FromGround(X_WR, 0.0));
  EXPECT_LT((belief.p_ET - X_RW * kPoint).norm(), 1e-12);
  EXPECT_LT((*belief.normal_E - X_RW.R * Eigen::Vector3d(-0.8, 0.0, 0.6)).norm(), 1e-12);
  EXPECT_LT((belief.obstacles_E[1] - Inverse(X_WR) * Eigen::Vector2d(3.2, 0.6)).norm(), 1e-12);
  EXPECT_NEAR(belief.turned_rad, -0.3, 1e-12);
  EXPECT_NEAR(belief.driven_m, 0.8, 1e-12);
  EXPECT_NEAR(belief.signed_m, 0.6, 1e-12);
}

// What it drifts to the left is the same whatever the range's error is.
TEST(FaceBelief, TellsADriftAsideFromAnErrorOfTheRange) {
  FaceBelief belief = Believed();
  MoveOn(Advance({}, Arc{0.4, 0.2}), 0.4, Eigen::Vector2d(0.0, 0.0), belief);
  const Eigen::Vector2d sight = belief.p_ET.head<2>().normalized();
  const Eigen::Vector3d left(-sight.y(), sight.x(), 0.0);
  for (const double range_off : {0.95, 1.0, 1.05}) {
    const Eigen::Vector3d p_E = range_off * belief.p_ET - 0.07 * left;
    EXPECT_NEAR(FurtherLeft(belief, p_E), 0.07, 1e-12) << range_off;
  }
}

TEST(FaceBelief, IsInTheTiltedBodyWhereTheLevelFrameHasIt) {
  const Nominal nominal = NominalRover();
  const ImuSample attitude{.roll_rad = 0.1, .pitch_rad = -0.05};
  const FaceAt face = FaceNow(nominal, attitude, Believed());
  const Pose3 X_ER{RotY(-0.05) * RotX(0.1), {0.0, 0.0, nominal.rolling_radius_m}};
  EXPECT_LT((X_ER * face.p_RT - kPoint).norm(), 1e-12);
  EXPECT_LT((X_ER.R * face.normal_R - Eigen::Vector3d(-0.8, 0.0, 0.6)).norm(), 1e-12);
}

TEST(FaceBelief, WithoutANormalTheFaceLeansBackByTwentyDegreesAlongTheLineOfSight) {
  FaceBelief belief = Believed();
  belief.normal_E.reset();
  const FaceAt face = FaceNow(NominalRover(), {}, belief);
  EXPECT_NEAR(std::asin(face.normal_R.z()), Radians(20.0), 1e-12);
  EXPECT_NEAR(face.normal_R.norm(), 1.0, 1e-12);
  const Eigen::Vector2d sight = kPoint.head<2>().normalized();
  EXPECT_NEAR(face.normal_R.head<2>().normalized().dot(sight), -1.0, 1e-12);
  EXPECT_FALSE(belief.IsNormalSure());
}

TEST(FaceBelief, ADetectionIsWhereTheTargetIsAndCountsAnew) {
  const Nominal nominal = NominalRover();
  FaceBelief belief = Believed();
  MoveOn(Advance({}, Arc{0.3, 0.1}), 0.3, Eigen::Vector2d(0.0, 0.0), belief);
  const Eigen::Vector3d p_E(2.71, 0.1, 0.34);
  Take(nominal, FaceStereo(nominal), BlindView(nominal), {.found = true, .p_E = p_E}, belief);
  EXPECT_EQ(belief.p_ET, p_E);
  EXPECT_EQ(belief.turned_rad, 0.0);
  EXPECT_EQ(belief.driven_m, 0.0);
  EXPECT_EQ(belief.signed_m, 0.0);
}

// A sure normal is averaged with the new one, which has 0.6 at least; an unsure one is replaced.
TEST(FaceBelief, NormalsAreFusedByTheirSigmas) {
  const Nominal nominal = NominalRover();
  const FaceStereo stereo(nominal);
  const Eigen::Vector3d was(-0.8, 0.0, 0.6), now(-1.0, 0.0, 0.0);
  for (const auto& [was_deg, now_deg, share] :
       {std::tuple{2.0, 2.0, 0.6}, {8.0, 2.0, 0.8}, {12.0, 2.0, 1.0}}) {
    FaceBelief belief = Believed();
    belief.normal_sigma_rad = Radians(was_deg);
    Take(nominal, stereo, BlindView(nominal), Sighted(kPoint, now, Radians(now_deg)), belief);
    const Eigen::Vector3d mean = ((1.0 - share) * was + share * now).normalized();
    EXPECT_LT((*belief.normal_E - mean).norm(), 1e-12) << was_deg;
    EXPECT_EQ(belief.normal_sigma_rad, Radians(now_deg));
  }
}

// The mast's cameras do not show the ground right before the wheels.
TEST(FaceBelief, KeepsObstaclesThatTheViewDoesNotHoldAndMovesThemWithTheTarget) {
  const Nominal nominal = NominalRover();
  const FaceStereo stereo(nominal);
  const FaceView view = BlindView(nominal);
  FaceBelief belief = Believed();
  belief.obstacles_E = {{0.75, 0.0}, {4.0, 0.0}};
  ASSERT_FALSE(stereo.Pixel(view, {0.75, 0.0, 0.1}, false));
  ASSERT_TRUE(stereo.Pixel(view, {4.0, 0.0, 0.1}, false));
  Take(nominal, stereo, view, Sighted(kPoint + Eigen::Vector3d(0.02, 0.01, 0.0), {-1, 0, 0}, 0.1),
       belief);
  ASSERT_EQ(belief.obstacles_E.size(), 1u);
  EXPECT_LT((belief.obstacles_E[0] - Eigen::Vector2d(0.77, 0.01)).norm(), 1e-12);
}

}  // namespace
}  // namespace dockyard::rocky7
