// The rover's way along the present arc, from its wheels, its inertial unit and what its looks
// taught of the slip.
#pragma once

#include <array>

#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"
#include "controller/motion/arcs.h"

namespace dockyard::rocky7 {

/// How far slip is off what is taken, 1 sigma, share of the way. Assumed, 0.05-0.12.
inline constexpr double kSlipSigma = 0.08;
/// More is not believed of looks. Assumed, 0.3-0.7.
inline constexpr double kMostSlip = 0.5;
/// Of the drift of a metre at a roll of 90 deg, 1 sigma; one run on compact gravel had 0.6.
/// Assumed, 0.5-1.5.
inline constexpr double kDriftSigma = 1.0;
/// What a rover with tandem wheels turns on an arc of 1 m, of what they count: 83 to 87 %
/// (docs/rocky7.md).
inline constexpr double kTurnShare = 0.85;

struct OdometryOptions {
  // The turn by the inertial unit in place of the wheels: tandem wheels slip aside on an arc, and
  // the rover turns by 83 to 87 % of what they count (docs/rocky7.md).
  bool turn_by_unit = false;
  // The share of its way that the rover slips, as it is taken at first and then learnt from looks,
  // ahead and back. With a start and a stop every 15 cm it is 20 % in sand (docs/rocky7.md). 0: the
  // wheels' counts are believed.
  double slip = 0.0;
  // The same of slip downhill on a cross slope, which is learnt from 0.
  bool drifts = false;
};

class Odometry {
 public:
  explicit Odometry(const OdometryOptions& options)
      : options_(options), slip_{options.slip, options.slip} {}

  /// An arc begins. The turn of the last one is learnt.
  void Begin(double yaw_rad);
  /// The motion since the last call, from what the wheels count of the arc.
  Pose2 Step(double driven_m, const Pose2& counted, const ImuSample& attitude);
  /// After a way that the wheels counted, negative back, the rover was further back along x than
  /// predicted by this.
  void Learn(double further_m, double sigma_m, double way_m);
  /// After a distance whose product with the sine of the roll sums up to this, the rover was
  /// further to the left than predicted by left_m.
  void LearnDrift(double left_m, double sigma_m, double rolled_m);
  /// To the left, for a distance at this roll (right side down positive).
  double DriftOn(double distance_m, double roll_rad) const;
  /// What that may be off after such a distance times the sine of the roll, 1 sigma; 0 where no
  /// drift is learnt.
  double DriftSigma(double rolled_m) const;
  /// On a way ahead, or back.
  double SlipOn(double way_m) const { return slip_[way_m < 0.0 ? 1 : 0]; }
  /// So that the rover itself, which slips, drives this arc. It may be sharper than its wheels
  /// steer.
  Arc AgainstSlip(const Arc& arc) const;
  /// What the rover turns, of what its wheels count.
  double turn_share() const { return turn_share_; }

 private:
  const OdometryOptions options_;
  std::array<double, 2> slip_{};
  double turn_share_ = kTurnShare;
  // To the left, of a metre at a roll of 90 deg, and its variance.
  double drift_ = 0.0, drift_variance_ = kDriftSigma * kDriftSigma;
  double yaw_at_start_rad_ = 0.0, yaw_before_rad_ = 0.0, driven_before_m_ = 0.0;
  Pose2 before_;
};

}  // namespace dockyard::rocky7
