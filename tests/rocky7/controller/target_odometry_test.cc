#include "controller/rocky7/ground_perception.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"
#include "sim/base/random.h"

namespace dockyard::rocky7 {
namespace {

constexpr OdometryOptions kSlipping{.turn_by_unit = true, .slip = 0.1};

// Smooth stains of the ground in the world.
float GreyAt(const Eigen::Vector2d& p_W) {
  RandomStream waves(5);
  double sum = 0.0;
  for (int i = 0; i < 30; ++i) {
    const double angle = waves.Uniform(-kPi, kPi), length_m = waves.Uniform(0.03, 0.15);
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    sum += std::cos(2.0 * kPi * along.dot(p_W) / length_m + waves.Uniform(-kPi, kPi));
  }
  return static_cast<float>(90.0 + 8.0 * sum);
}

// It from above, about a rover at X_WR.
GroundImage GroundFrom(const Pose2& X_WR) {
  GroundImage picture{.x0_m = 0.2, .y0_m = -0.4, .cell_m = 0.01, .nx = 80, .ny = 80};
  for (int iy = 0; iy < picture.ny; ++iy) {
    for (int ix = 0; ix < picture.nx; ++ix) {
      picture.grey.push_back(GreyAt(X_WR * Eigen::Vector2d(0.2 + 0.01 * ix, -0.4 + 0.01 * iy)));
    }
  }
  return picture;
}

// Wheels that turn as they are told, over ground on which the rover comes less far.
struct Rover {
  Nominal nominal = NominalRover();
  ArcDrive drive{nominal};
  TargetOdometry odometry{kSlipping};
  Pose2 X_WR;
  SensorFrame frame;
  double slip = 0.3;
  GroundMemory memory{};
  Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();  // of the last prediction

  Rover() { frame.motors.resize(nominal.motors.size()); }

  void Rest() {
    frame.tick += kControlPeriod;
    odometry.Step(drive, false, frame);
  }
  void Go(const Arc& arc) {
    drive.Start(arc);
    odometry.BeginArc(arc, frame.imu.yaw_rad);
    double before_m = 0.0;
    while (!drive.done()) {
      frame.tick += kControlPeriod;
      const auto commands = drive.Step(frame);
      odometry.Step(drive, true, frame);
      const Arc gone{(1.0 - slip) * (drive.driven_m() - before_m), 0.0};
      before_m = drive.driven_m();
      X_WR = Advance(X_WR, gone);
      for (std::size_t i = 0; i < commands.size(); ++i) {
        if (commands[i].mode != MotorMode::kPosition) continue;
        const double rad_per_count = nominal.motors[i].rad_per_count;
        const double step = commands[i].speed_limit_rad_s * kControlPeriod * kTickSeconds;
        const double now = static_cast<double>(frame.motors[i].encoder_counts) * rad_per_count;
        frame.motors[i].encoder_counts =
            std::llround((now + std::clamp(commands[i].target - now, -step, step)) / rad_per_count);
      }
    }
  }
  /// An image pair in which the target is detected where it is, or not. Whether the ground showed
  /// the motion.
  bool Detect(const std::optional<Eigen::Vector2d>& p_WT) {
    const ExposurePrior prior = odometry.At(frame.tick);
    GroundDetection detection{.predicted = prior.target};
    CompareGround(GroundFrom(X_WR), prior, memory, detection);
    if (p_WT) detection.sighting = {.found = true, .p_E = Inverse(X_WR) * *p_WT};
    odometry.Take(prior, detection);
    spread_m2 = detection.predicted.spread_m2;
    return detection.X_BE.has_value();
  }
};

TEST(TargetOdometry, HasTheTargetWithinMillimetresWhereTheGroundShowsThatWheelsSlipped) {
  const Eigen::Vector2d p_WT(1.2, 0.1);
  Rover rover;
  rover.Rest();
  rover.Detect(p_WT);
  rover.Go({0.2, 0.0});
  // Slip is thrice what is taken: 4 cm.
  EXPECT_GT((rover.odometry.p_RT() - Inverse(rover.X_WR) * p_WT).norm(), 0.03);
  EXPECT_TRUE(rover.Detect({}));
  EXPECT_LT((rover.odometry.p_RT() - Inverse(rover.X_WR) * p_WT).norm(), 0.003);
  EXPECT_LT(rover.spread_m2.trace(), 2.0 * 0.003 * 0.003);
  // What was learnt is most of the slip.
  rover.Go({0.2, 0.0});
  EXPECT_LT((rover.odometry.p_RT() - Inverse(rover.X_WR) * p_WT).norm(), 0.02);
}

TEST(TargetOdometry, SeesThatTheRoverStoodStillWhileItsWheelsTurned) {
  const Eigen::Vector2d p_WT(1.0, 0.0);
  Rover rover;
  rover.slip = 1.0;
  rover.Rest();
  rover.Detect(p_WT);
  rover.Go({0.2, 0.0});
  EXPECT_TRUE(rover.Detect({}));
  EXPECT_LT((rover.odometry.p_RT() - p_WT).norm(), 0.003);
}

// 4.5 cm go by between an image's exposure and its arrival.
TEST(TargetOdometry, CountsALateLookFromWhenItWasExposed) {
  const Eigen::Vector2d p_WT(1.0, 0.0);
  Rover rover;
  rover.slip = 0.1;
  rover.Rest();
  rover.Detect(p_WT);
  const Tick exposed = rover.frame.tick;
  rover.Go({0.05, 0.0});
  const ExposurePrior prior = rover.odometry.At(exposed);
  EXPECT_LT((prior.target.p_RT - p_WT).norm(), 1e-3);
  const TargetSighting sighting{.found = true, .p_E = p_WT + Eigen::Vector2d(0.0, 0.02)};
  rover.odometry.Take(prior, {.sighting = sighting, .predicted = prior.target});
  const Eigen::Vector2d now = Inverse(rover.X_WR) * Eigen::Vector2d(p_WT.x(), 0.02);
  EXPECT_LT((rover.odometry.p_RT() - now).norm(), 2e-3);
}

}  // namespace
}  // namespace dockyard::rocky7
