// A rover on level ground without dynamics: drives that follow their commands, wheels that slip by
// a share, a mast, a face with switches before it, and cameras.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "controller/io/commands.h"
#include "controller/motion/arcs.h"
#include "controller/rocky7/mast.h"
#include "rocky7/controller/face_scene.h"

namespace dockyard::rocky7 {

struct IdealRover {
  static constexpr double kSpring_n_m = 500.0, kSwitch_n = 1.0;

  Nominal nominal = NominalRover();
  FaceScene scene;
  Pose2 X_WR;
  double slip = 0.06;
  std::vector<double> angles = std::vector<double>(15), speeds = std::vector<double>(15);
  Tick tick = 0;
  double most_n = 0.0;
  std::vector<double> closed = {0, 0, 0};
  std::vector<int> asked;
  Eigen::Vector3d touched_W{0, 0, 0};  // the face's middle where the force was most
  Eigen::Vector3d tool_W{1, 0, 0};
  double nearest_wheel_m = 10.0;

  IdealRover() {
    for (std::size_t i = 0; i < 3; ++i) angles[12 + i] = nominal.mast.watch_rad[i];
  }
  MastAngles mast() const { return {angles[12], angles[13], angles[14]}; }

  void Turn(const Commands& commands) {
    constexpr double dt = 1e-3;
    for (int ms = 0; ms < kControlPeriod; ++ms) {
      const double before = 0.25 * (angles[2] + angles[3] + angles[4] + angles[5]);
      for (std::size_t i = 0; i < angles.size(); ++i) {
        const MotorCommand& command = commands.motors[i];
        if (command.mode != MotorMode::kPosition) {
          speeds[i] = 0.0;
          continue;
        }
        const double left = command.target - angles[i];
        const double fast = std::min(command.speed_limit_rad_s,
                                     std::sqrt(2.0 * command.accel_rad_s2 * std::abs(left)));
        const double wanted = std::copysign(std::min(fast, std::abs(left) / dt), left);
        speeds[i] +=
            std::clamp(wanted - speeds[i], -command.accel_rad_s2 * dt, command.accel_rad_s2 * dt);
        angles[i] += dt * speeds[i];
      }
      const double after = 0.25 * (angles[2] + angles[3] + angles[4] + angles[5]);
      const double way_m = (1.0 - slip) * (after - before) * nominal.rolling_radius_m;
      double curvature = 0.0;
      if (std::abs(angles[6]) > 1e-6) {
        const Eigen::Vector2d& p = nominal.plan.wheels[0].p_RW;
        curvature = 1.0 / (p.x() / std::tan(angles[6]) + p.y());
      }
      X_WR = Advance(X_WR, Arc{way_m, 0.87 * curvature * way_m});
      Press();
    }
    asked = commands.take_images;
    tick += kControlPeriod;
  }

  void Press() {
    const Pose3 X_WK =
        FromGround(X_WR, nominal.rolling_radius_m) * SecondLink(nominal.mast, mast());
    double force_n = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double turn = 2.0 * kPi / 3.0 * static_cast<double>(i);
      const double r = nominal.mast.switch_radius_m;
      const Eigen::Vector3d p =
          X_WK * Eigen::Vector3d(nominal.mast.link2_m, r * std::sin(turn), r * std::cos(turn));
      const double one_n = kSpring_n_m * std::max(0.0, -scene.normal_W.dot(p - scene.p_W));
      closed[i] = one_n > kSwitch_n;
      force_n += one_n;
    }
    if (force_n > most_n) {
      most_n = force_n;
      touched_W = X_WK * Eigen::Vector3d(nominal.mast.link2_m, 0.0, 0.0);
      tool_W = X_WK.R.col(0);
    }
    const Eigen::Vector2d front = X_WR * Eigen::Vector2d(0.479, 0.0);
    const Eigen::Vector2d to = scene.p_W.head<2>() - front;
    const Eigen::Vector2d ahead = -scene.normal_W.head<2>().normalized();
    nearest_wheel_m = std::min(nearest_wheel_m, to.dot(ahead));
  }

  SensorFrame Frame() const {
    SensorFrame frame;
    frame.tick = tick;
    frame.imu.yaw_rad = X_WR.heading;
    frame.motors.resize(angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i) {
      frame.motors[i].encoder_counts = std::llround(angles[i] / 1e-4);
      frame.motors[i].current_a = 0.2;
    }
    frame.values = closed;
    if (!asked.empty()) {
      const StereoImages pair = scene.Pair(nominal, X_WR, mast());
      frame.images = {{kMastLeft, pair.left, tick}, {kMastRight, pair.right, tick}};
    }
    return frame;
  }

  /// Puts the user's click where the first image shows the face's point.
  void Click() {
    const Pose3 X_WK =
        FromGround(X_WR, nominal.rolling_radius_m) * SecondLink(nominal.mast, mast());
    nominal.target_px =
        *nominal.mast.pair_K.left.Project(Inverse(X_WK * nominal.mast.pair_K.X_RL) * scene.p_W);
  }
};

}  // namespace dockyard::rocky7
