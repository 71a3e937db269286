// The rover's pose in the dock frame, by an extended Kalman filter (Kalman 1960; Thrun, Burgard and
// Fox, Probabilistic Robotics, 2005, ch. 7). Its states are x, y, heading, the tether's whole
// length, the four coefficients of slip and the error of the drum's radius. Odometry, sightings of
// the board and the taut tether feed it. The tether measures the distance to the station, however
// much the wheels slip. Sightings after a way teach the slip, as the rover ends elsewhere than it
// was reckoned to be.
#pragma once

#include <Eigen/Core>

#include "controller/axel/ground_slope.h"
#include "controller/axel/odometry.h"
#include "controller/axel/tether_length.h"
#include "controller/axel/wheel_slip.h"
#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

/// Standard deviations. Growths are per square root of distance or time.
struct FilterNoise {
  // What forces do not tell of the way ahead: 0.02 of a leg's way on loose, 0.05 on compact soil
  // (339 simulated legs forwards). Range 0.03-0.07.
  double along_m_per_sqrt_m = 0.05;
  // What side forces do not tell of scrubbing sideways; assumed, range 0.01-0.04.
  double across_m_per_sqrt_m = 0.02;
  // Slips before they are learned, from 413 simulated legs on both soils. Sideways a force gives
  // 0.2 to 3 of its share, in the mean 1.05 of gravity's and 0.87 of the tether's. Ahead, rolling
  // over paddles loses 0.08-0.15, and a force gives 0.9 of its share on loose and 1.7 on compact
  // soil, gravity and tether alike.
  WheelSlip slip{.slope = 1.05, .tether = 0.87, .rolling = 0.11, .ahead = 1.2};
  double side_slip_sigma = 0.7;  // half of the ranges above, as the next two
  double rolling_sigma = 0.04, ahead_sigma = 0.4;
  double slip_per_sqrt_m = 0.1;            // soil changes from place to place; assumed, 0.03-0.2
  double rolling_per_sqrt_m = 0.01;        // assumed, 0.003-0.02
  double weight_n = 390.0;                 // of the rover, for side forces; assumed, 250-590
  double heading_rad_per_sqrt_m = 0.005;   // inertial yaw while driving; assumed, 0.002-0.01
  double heading_rad_per_sqrt_s = 0.0002;  // yaw drift at rest; assumed, 0.0001-0.0005
  // Tsai et al., V-E: 0.20 m at 5 m, growing as the square of the range.
  double range_m_per_m2 = 0.008;
  // The pipeline's own account instead, if it gives one, and the floors for what it does not know.
  double range_floor_m = 0.012;
  // Half of a relative camera yaw error of 0.16 deg and a pixel or two; assumed, 0.003-0.02.
  double bearing_rad = 0.008;
  // Tsai et al., V-E give mean heading errors of 2.5 deg at 1 m and 4.6 deg at 2 m with four-pixel
  // class detections; 0.7 deg + 0.8 deg/m assumed for sub-pixel marks, range 0.3-2.3 deg/m.
  double board_heading_floor_rad = 0.012;
  double board_heading_rad_per_m = 0.014;
  double tether_m = 0.02;  // lip bends, stretch, arm elevation; assumed, range 0.005-0.04
  // Error of the drum's radius, and its change with the layers on it. A drum is built to 5 %, and
  // grows by as much over 4 m of tether. Assumed, 0.01-0.05 and 0.005-0.02.
  double drum_sigma = 0.03, drum_per_sqrt_m = 0.01;
  // Squared Mahalanobis distance beyond which a sighting contradicts the estimate: chi-square, 3
  // degrees of freedom, 99.99 %.
  double gate = 21.1;
};

/// A sighting reduced to the ground's plane.
struct BoardFix {
  double range_m = 0.0, bearing_rad = 0.0;  // of the board's centre, bearing from the x axis
  double heading_rad = 0.0;                 // the rover's heading in D
  // Variances of the three by the pipeline's own account; zero: it gives none.
  Eigen::Vector3d variance = Eigen::Vector3d::Zero();
};
/// Turns a sighting by the inertial unit's attitude, taken against the ground, and takes its planar
/// part.
BoardFix LevelSighting(const Pose3& X_RB, const ImuSample& imu, const Pose3& X_DB,
                       const GroundSlope& ground);
/// Variances of the fix of a sighting with this covariance: of p_RB [m], then of a small turn of
/// the board about R's axes [rad]. The body's tilt is small.
Eigen::Vector3d FixVariance(const Eigen::Vector3d& p_RB,
                            const Eigen::Matrix<double, 6, 6>& covariance);
/// The rover's pose that a fix implies.
Pose2 PoseOf(const BoardFix& fix, const Pose3& X_DB);

class PoseFilter {
 public:
  PoseFilter(const FilterNoise& noise, const TetherGeometry& geometry, const Pose3& X_DB)
      : noise_(noise), geometry_(geometry), X_DB_(X_DB) {
    state_.tail<5>() << noise.slip.slope, noise.slip.tether, noise.slip.rolling, noise.slip.ahead,
        0.0;
    Eigen::Matrix<double, 5, 1> sigma;
    sigma << noise.side_slip_sigma, noise.side_slip_sigma, noise.rolling_sigma, noise.ahead_sigma,
        noise.drum_sigma;
    P_.diagonal().tail<5>() = sigma.cwiseAbs2();
  }

  bool located() const { return located_; }
  Pose2 pose() const { return {state_.x(), state_.y(), state_.z()}; }
  /// Estimated exposed tether; reeled_m is the length that the drum took up since power-on.
  double ExposedLength(double reeled_m) const { return state_(3) - drum_scale() * reeled_m; }
  /// Length that the drum takes up for each metre that its turns say.
  double drum_scale() const { return 1.0 + state_(8); }
  /// Whether the tether's whole length has been estimated yet.
  bool TetherKnown() const { return located_ && P_(3, 3) < 1.0; }

  /// Wheels that run free do not slip along their way.
  void Predict(const Motion& motion, double seconds, const GroundForce& force = {},
               bool free = false);
  WheelSlip slip() const { return {state_(4), state_(5), state_(6), state_(7)}; }
  /// Whether the fix agrees with the estimate; true before the first.
  bool Fits(const BoardFix& fix) const;
  void Correct(const BoardFix& fix);
  /// Forgets the pose and begins again at this fix.
  void Restart(const BoardFix& fix);
  /// For a taut tether: its length gives the distance from the tip to the mouth. Elevation is
  /// against the ground.
  void CorrectByTether(double reeled_m, double elevation_rad);

 private:
  static constexpr int kStates = 9;
  using Vector = Eigen::Matrix<double, kStates, 1>;
  using Matrix = Eigen::Matrix<double, kStates, kStates>;
  struct Innovation;
  Innovation Compare(const BoardFix& fix) const;
  Eigen::Vector3d VarianceOf(const BoardFix& fix) const;
  void Take(const Vector& change, const Matrix& kept);

  FilterNoise noise_;
  TetherGeometry geometry_;
  Pose3 X_DB_;
  bool located_ = false;
  // x, y, heading, whole tether, slips as in WheelSlip, drum's error
  Vector state_ = Vector::Zero();
  Matrix P_ = Matrix::Identity();
};

}  // namespace dockyard::axel
