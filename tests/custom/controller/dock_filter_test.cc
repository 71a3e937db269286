#include "controller/custom/dock_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>

#include "controller/motion/arcs.h"
#include "sim/base/random.h"

namespace dockyard::custom {
namespace {

/// A robot on a curve before the dock, its odometry and its sightings.
struct DrivenRobot {
  explicit DrivenRobot(std::uint64_t seed, double bearing_rad = 0.3)
      : random(seed), X_DA{2.0 * std::cos(bearing_rad), 2.0 * std::sin(bearing_rad), kPi} {}

  /// One control period; odometry errs as the noise says.
  void Step(const OdometryNoise& noise, double length_m, double turn_rad, DockFilter* filter) {
    X_DA = Advance(X_DA, Arc{length_m, turn_rad});
    const double turn_error = std::hypot(noise.turn_share_imu * std::sqrt(std::abs(turn_rad)),
                                         noise.drift_rad_per_sqrt_s * std::sqrt(0.02));
    const Motion read{
        length_m + noise.length_share * std::sqrt(std::abs(length_m)) * random.Normal(),
        turn_rad + turn_error * random.Normal()};
    X_OA = Advance(X_OA, Arc{read.length_m, read.turn_rad});
    const double aside = noise.aside_share * std::sqrt(std::abs(length_m)) * random.Normal();
    X_OA = X_OA * Pose2{0.0, aside, 0.0};
    filter->Drive(X_OA, read, 0.02);
  }

  /// The dock in O by a sighting: by its false branch, then by the true one. The false branch is
  /// turned by twice the angle between the sight and the board's normal, and errs alike.
  std::vector<DockFix> Fixes(const Eigen::Vector3d& sigma) {
    Pose2 X_AD = Inverse(X_DA);
    X_AD.x += sigma.x() * random.Normal();
    X_AD.y += sigma.y() * random.Normal();
    X_AD.heading = WrapPi(X_AD.heading + sigma.z() * random.Normal());
    const Pose2 X_DA_found = Inverse(X_AD);
    Pose2 mirrored = X_AD;
    mirrored.heading = WrapPi(X_AD.heading + 2.0 * std::atan2(X_DA_found.y, X_DA_found.x));
    const Eigen::Matrix3d R = RotZ(X_OA.heading);
    const Eigen::Matrix3d covariance = R * sigma.cwiseAbs2().asDiagonal() * R.transpose();
    return {{X_OA * mirrored, covariance, 0.0}, {X_OA * X_AD, covariance, 0.0}};
  }
  DockFix Fix(const Eigen::Vector3d& sigma) { return Fixes(sigma)[1]; }

  /// Of the dock's pose in O against where it is now for a robot that believes its odometry.
  Eigen::Vector3d Error(const DockFilter& filter) const {
    const Pose2 truth = X_OA * Inverse(X_DA), found = filter.X_OD();
    return {found.x - truth.x, found.y - truth.y, WrapPi(found.heading - truth.heading)};
  }

  RandomStream random;
  Pose2 X_DA, X_OA{0.0, 0.0, 0.0};
};

TEST(DockFilter, ErrsAsItsCovarianceSays) {
  const OdometryNoise noise{};
  const Eigen::Vector3d sigma(0.02, 0.005, 0.03);
  double sum = 0.0;
  const int count = 300;
  for (int seed = 0; seed < count; ++seed) {
    DrivenRobot drive(static_cast<std::uint64_t>(seed) + 1);
    DockFilter filter(noise, true, {.place_m = 0.0});  // each sighting errs on its own
    for (int i = 0; i < 300; ++i) {
      if (i % 10 == 0) filter.See({drive.Fix(sigma)});
      drive.Step(noise, 0.004, i < 150 ? 0.003 : -0.003, &filter);
    }
    const Eigen::Vector3d error = drive.Error(filter);
    sum += error.dot(filter.covariance().inverse() * error);
  }
  // Chi-square of 3 degrees of freedom: mean 3, 1 sigma sqrt(6 / count).
  EXPECT_NEAR(sum / count, 3.0, 4.0 * std::sqrt(6.0 / count));
}

TEST(DockFilter, DoesNotAverageErrorsThatOnePlaceShares) {
  // The error is drawn anew every 0.12 m. Chi-square of 3 degrees of freedom; the weights leave
  // it too sure by no more than the sum of 1 / m over ten sightings, which is 2.9.
  const OdometryNoise noise{};
  const Eigen::Vector3d sigma(0.02, 0.005, 0.03);
  double sum = 0.0;
  const int count = 200;
  for (int seed = 0; seed < count; ++seed) {
    DrivenRobot drive(static_cast<std::uint64_t>(seed) + 1);
    DockFilter filter(noise, true);
    Eigen::Vector3d shared = Eigen::Vector3d::Zero();
    for (int i = 0; i < 300; ++i) {
      if (i % 30 == 0)
        for (int k = 0; k < 3; ++k) shared(k) = sigma(k) * drive.random.Normal();
      if (i % 3 == 0) {
        DockFix fix = drive.Fix(Eigen::Vector3d::Zero());
        const Eigen::Matrix3d R = RotZ(drive.X_OA.heading);
        const Eigen::Vector3d error = R * shared;
        fix.X_OD = {fix.X_OD.x + error.x(), fix.X_OD.y + error.y(), fix.X_OD.heading + error.z()};
        fix.covariance = R * sigma.cwiseAbs2().asDiagonal() * R.transpose();
        filter.See({fix});
      }
      drive.Step(noise, 0.004, i < 150 ? 0.003 : -0.003, &filter);
    }
    const Eigen::Vector3d error = drive.Error(filter);
    sum += error.dot(filter.covariance().inverse() * error);
  }
  std::printf("chi-square of 3: %.2f\n", sum / count);
  EXPECT_LT(sum / count, 3.0 * 2.9);
}

TEST(DockFilter, IsNeverSurerThanTheErrorThatAllSightingsShare) {
  const Eigen::Vector3d sigma(0.02, 0.005, 0.03);
  DrivenRobot drive(4);
  DockFilter filter({}, true);
  for (int i = 0; i < 400; ++i) {
    DockFix fix = drive.Fix(sigma);
    fix.lasting = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
    filter.See({fix});
    if (i % 4 == 0) drive.Step({}, 0.004, 0.0, &filter);
  }
  EXPECT_GT(filter.covariance()(2, 2), 1e-4);
  EXPECT_LT(filter.covariance()(2, 2), 2e-4);
}

TEST(DockFilter, IsNotLedToTheFalseBranchByOneImageShownManyTimes) {
  // The true branch fits a worn tag worse, alike in each image at rest.
  const Eigen::Vector3d sigma(0.02, 0.005, 0.03);
  DrivenRobot drive(6, 0.35);
  DockFilter filter({}, true);
  for (int i = 0; i < 100; ++i) {
    std::vector<DockFix> fixes = drive.Fixes(sigma);
    fixes[1].misfit = 3.0;
    filter.See(fixes);
  }
  EXPECT_TRUE(filter.open());
}

TEST(DockFilter, DecidesForTheTrueBranchOnceTheRobotHasMoved) {
  const OdometryNoise noise{};
  const Eigen::Vector3d sigma(0.02, 0.005, 0.03);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    DrivenRobot drive(seed, seed % 2 == 0 ? 0.35 : -0.35);
    DockFilter filter(noise, true);
    filter.See(drive.Fixes(sigma));
    EXPECT_TRUE(filter.open());
    const double aside = drive.X_DA.y;
    for (int i = 0; i < 250; ++i) {  // to the axis and over it
      const double turn = i < 50 ? std::copysign(0.015, aside) : 0.0;
      drive.Step(noise, 0.005, turn, &filter);
      if (i % 10 == 0) filter.See(drive.Fixes(sigma));
    }
    EXPECT_FALSE(filter.open()) << seed;
    EXPECT_LT(std::abs(drive.Error(filter).z()), 0.1) << seed;
  }
}

TEST(DockFilter, KeepsBothBranchesAtRest) {
  const Eigen::Vector3d sigma(0.02, 0.005, 0.03);
  int open = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    DrivenRobot drive(seed, 0.35);
    DockFilter filter({}, true);
    for (int i = 0; i < 20; ++i) filter.See(drive.Fixes(sigma));
    if (filter.open()) ++open;
  }
  EXPECT_GT(open, 45);
}

TEST(DockFilter, LeavesOutAnOutlierAndFollowsADockThatIsElsewhere) {
  const Eigen::Vector3d sigma(0.02, 0.005, 0.03);
  DrivenRobot drive(5);
  DockFilter filter({}, true);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(filter.See({drive.Fix(sigma)}));
  const Pose2 before = filter.X_OD();
  DockFix other = drive.Fix(sigma);
  other.X_OD.x += 0.5;
  EXPECT_FALSE(filter.See({other}));
  EXPECT_EQ(filter.X_OD(), before);
  DockFix tilted = drive.Fix(sigma);
  tilted.misfit = 20.0;
  EXPECT_FALSE(filter.See({tilted}));
  for (int i = 0; i < 5; ++i) filter.See({other});
  EXPECT_NEAR(filter.X_OD().x, other.X_OD.x, 0.05);
}

}  // namespace
}  // namespace dockyard::custom
