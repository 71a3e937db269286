#include "controller/rocky7/target_odometry.h"

#include <cmath>

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector2d;

// Odometry's error to the side, share of the distance, 1 sigma, the heading being known: tandem
// wheels slip sideways on arcs. Assumed, 0.02-0.08.
constexpr double kSideSlip = 0.05;
// A body that tips over stones moves its middle by this, which is no slip. Assumed, 5-15 mm.
constexpr double kTips_m = 0.01;

}  // namespace

Predicted OdometryTarget::predicted() const {
  return {{p_RT.x(), p_RT.y(), WrapPi(-turned_rad)}, spread_m2, driven_m};
}

OdometryTarget InFrame(const OdometryTarget& target, const Pose2& X_NR, double turned_rad) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-turned_rad).toRotationMatrix();
  return {X_NR * target.p_RT, turn * target.spread_m2 * turn.transpose(),
          target.turned_rad + turned_rad, target.driven_m};
}

Arc TargetOdometry::AgainstSlip(const Arc& arc) const { return odometry_.AgainstSlip(arc); }

void TargetOdometry::BeginArc(const Arc& arc, double yaw_rad) {
  odometry_.Begin(yaw_rad);
  driven_m_ = 0.0;
  const double along_m = kSlipSigma * arc.length_m, aside_m = kSideSlip * arc.length_m;
  now_.spread_m2 += Vector2d(along_m * along_m, aside_m * aside_m).asDiagonal();
}

void TargetOdometry::Step(const ArcDrive& drive, bool drives, const SensorFrame& sensed) {
  if (drives) {
    const Pose2 since = odometry_.Step(drive.driven_m(), drive.moved(), sensed.imu);
    X_OR_ = X_OR_ * since;
    now_ = InFrame(now_, Inverse(since), since.heading);
    const double driven_m = drive.driven_m() - driven_m_;
    driven_m_ = drive.driven_m();
    now_.driven_m += driven_m;
    since_m_ += driven_m;
    all_since_m_ += std::abs(driven_m);
    rolled_m_ += std::abs(driven_m) * std::sin(sensed.imu.roll_rad);
  }
  roll_rad_ = sensed.imu.roll_rad;
  past_.Add({sensed.tick, X_OR_, sensed.imu});
}

ExposurePrior TargetOdometry::At(Tick exposed) const {
  const PastMoment& then = past_.Nearest(exposed);
  const Pose2 X_ER = Inverse(then.X_OR) * X_OR_;
  return {.attitude = then.imu,
          .target = InFrame(now_, X_ER, -X_ER.heading),
          .before = before_,
          .X_BE = Inverse(X_OB_) * then.X_OR,
          .X_OE = then.X_OR,
          .X_ER = X_ER};
}

// The distance is that of one arc, or of arcs in one direction.
void TargetOdometry::Learn(double further_m) {
  if (std::abs(since_m_) < all_since_m_) return;
  odometry_.Learn(further_m, kTips_m, since_m_);
}

Vector2d TargetOdometry::DriftOn(double distance_m) const {
  return {0.0, odometry_.DriftOn(distance_m, roll_rad_)};
}

void TargetOdometry::Take(const ExposurePrior& prior, const GroundDetection& detection) {
  const TargetSighting& sighting = detection.sighting;
  const bool detected = sighting.found || sighting.guess;
  if (detection.X_BE) {
    Learn(prior.X_BE.x - detection.X_BE->x);
    odometry_.LearnDrift(detection.X_BE->y - prior.X_BE.y, kTips_m, rolled_m_);
  } else if (detected && sighting.further_m != 0.0) {
    Learn(sighting.further_m);
  }
  before_ = detected ? OdometryTarget{.p_RT = sighting.p_E} : detection.predicted;
  X_OB_ = prior.X_OE;
  since_m_ = all_since_m_ = rolled_m_ = 0.0;
  now_ = InFrame(before_, Inverse(prior.X_ER), prior.X_ER.heading);
}

}  // namespace dockyard::rocky7
