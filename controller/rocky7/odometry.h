// The rover's way along the present arc, from its wheels, its inertial unit and what its looks
// taught of the slip.
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard::rocky7 {

/// How far slip is off what is taken, 1 sigma, share of the way. Assumed, 0.05-0.12.
inline constexpr double kSlipSigma = 0.08;
/// More is not believed of looks. Assumed, 0.3-0.7.
inline constexpr double kMostSlip = 0.5;

struct OdometryOptions {
  // The turn by the inertial unit in place of the wheels: tandem wheels slip aside on an arc, and
  // the rover turns by 83 to 87 % of what they count (docs/rocky7.md).
  bool turn_by_unit = false;
  // The share of its way that the rover slips, as it is taken at first and then learnt from looks;
  // 0: the wheels' counts are believed.
  double slip = 0.0;
};

class Odometry {
 public:
  explicit Odometry(const OdometryOptions& options) : options_(options), slip_(options.slip) {}

  /// An arc begins.
  void Begin(double yaw_rad);
  /// The motion since the last call, from what the wheels count of the arc.
  Pose2 Step(double driven_m, const Pose2& counted, double yaw_rad);
  /// A target straight ahead was found further away than predicted by this, after a way.
  void Learn(double further_m, double sigma_m, double way_m);
  double slip() const { return slip_; }

 private:
  const OdometryOptions options_;
  double slip_ = 0.0, yaw_at_start_rad_ = 0.0;
  Pose2 before_;
};

}  // namespace dockyard::rocky7
