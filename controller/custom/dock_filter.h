// Where the dock is in the odometry's frame O, by Kalman filters on sightings and odometry.
//
// One camera leaves two poses of a planar board open. Each is a hypothesis with a filter of its own
// until one of them contradicts the motion: the dock does not move, so the sightings of the false
// branch do not agree with each other from different places.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/custom/odometry.h"
#include "controller/geometry/pose.h"

namespace dockyard::custom {

/// Errors of odometry, 1 sigma. They are those of independent stretches of 1 m and of 1 rad.
struct OdometryNoise {
  double length_share = 0.02;            // radius of wheels, slip; assumed, 1-4 %
  double aside_share = 0.01;             // drift to the side; assumed, 0.5-2 %
  double turn_share = 0.03;              // of the wheels' turns; assumed, 1-10 %
  double turn_share_imu = 0.005;         // of the unit's turns; assumed, 0.1-1 %
  double drift_rad_per_sqrt_s = 0.0003;  // of the unit; assumed, 1e-4 to 1e-3
  double heading_rad_per_sqrt_m = 0.01;  // without the unit, unlike sides; assumed, 0.005-0.02
};

/// The dock by one branch of a sighting, at its exposure.
struct DockFix {
  Pose2 X_OD;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double misfit = 0.0;  // chi-square of the floor and of the reprojection against the best branch
  // The part of the covariance that is the same error in each sighting: no number of them averages
  // it. Of calibration and mountings.
  Eigen::Matrix3d lasting = Eigen::Matrix3d::Zero();
};

/// How the errors of sightings hang together.
struct SightingErrors {
  // Sightings from within this of one place have nearly one error: light, worn ink and the grid of
  // pixels are the same. The m-th of them counts 1 / m of the first. Assumed, 0.05-0.2 m.
  double place_m = 0.1;
  double wild_share = 0.05;  // of sightings that are wrong for no known reason; assumed, 1-10 %
};

class DockFilter {
 public:
  DockFilter(const OdometryNoise& noise, bool has_imu, const SightingErrors& errors = {})
      : noise_(noise), has_imu_(has_imu), errors_(errors) {}

  /// Odometry says that A came to X_OA by this motion.
  void Drive(const Pose2& X_OA, const Motion& motion, double dt_s);
  /// Both branches of a sighting, or one. Returns whether the likeliest hypothesis took it.
  bool See(const std::vector<DockFix>& fixes);
  /// The estimate is less sure than it was, for slip that the encoders do not show.
  void Loosen(double sigma_m, double sigma_rad);

  bool located() const { return !kept_.empty(); }
  /// By the likeliest hypothesis; located() must hold.
  Pose2 X_OD() const;
  Eigen::Matrix3d covariance() const { return kept_.front().P + lasting_; }
  bool open() const { return kept_.size() > 1; }

 private:
  struct Hypothesis {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d P = Eigen::Matrix3d::Zero();
    double score = 0.0;  // chi-square so far
    int missed = 0;      // sightings in a row
  };
  bool Take(const std::vector<DockFix>& fixes, double weight, Hypothesis* hypothesis) const;
  double CountHere();
  void Restart(const std::vector<DockFix>& fixes);
  void Decide();

  OdometryNoise noise_;
  bool has_imu_;
  SightingErrors errors_;
  Eigen::Matrix3d lasting_ = Eigen::Matrix3d::Zero();
  Pose2 X_OA_, X_OA_place_;       // now, and at the first sighting from this place
  int from_here_ = 0;             // sightings from this place
  std::vector<Hypothesis> kept_;  // the likeliest first
};

}  // namespace dockyard::custom
