#include "controller/rocky7/target_odometry.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace dockyard::rocky7 {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// Of odometry aside, of the way, 1 sigma, the heading being known: tandem wheels slip aside on
// arcs. Assumed, 0.02-0.08.
constexpr double kSideSlip = 0.05;
// Of the turn by the inertial unit between two looks. Assumed, 0.1-0.5 deg.
constexpr double kYawSigma_rad = Radians(0.3);
// The motion is looked for about these shares of the way that was counted: wheels may have been
// stuck. Assumed.
constexpr std::array<double, 3> kShares{1.0, 0.5, 0.0};
// A body that tips over stones moves its middle by this, which is no slip. Assumed, 5-15 mm.
constexpr double kTips_m = 0.01;
// Pictures come no later. Assumed, 1-5 s.
constexpr Tick kLatest = 3000;

Matrix2d Turned(const Matrix2d& spread, double by_rad) {
  const Matrix2d turn = Eigen::Rotation2Dd(by_rad).toRotationMatrix();
  return turn * spread * turn.transpose();
}

}  // namespace

Predicted TargetOdometry::predicted() const {
  return {{now_.p_RT.x(), now_.p_RT.y(), WrapPi(-now_.turned_rad)}, now_.spread_m2, now_.way_m};
}

Arc TargetOdometry::AgainstSlip(const Arc& way) const {
  return {way.length_m / (1.0 - odometry_.SlipOn(way.length_m)),
          way.turn_rad / odometry_.turn_share()};
}

void TargetOdometry::BeginArc(const Arc& arc, double yaw_rad) {
  odometry_.Begin(yaw_rad);
  driven_m_ = 0.0;
  const double along_m = kSlipSigma * arc.length_m, aside_m = kSideSlip * arc.length_m;
  now_.spread_m2 += Vector2d(along_m * along_m, aside_m * aside_m).asDiagonal();
}

void TargetOdometry::Step(const ArcDrive& drive, bool drives, const SensorFrame& sensed) {
  if (drives) {
    const Pose2 since = odometry_.Step(drive.driven_m(), drive.moved(), sensed.imu.yaw_rad);
    X_OR_ = X_OR_ * since;
    now_.p_RT = Inverse(since) * now_.p_RT;
    now_.turned_rad += since.heading;
    now_.spread_m2 = Turned(now_.spread_m2, -since.heading);
    const double way_m = drive.driven_m() - driven_m_;
    driven_m_ = drive.driven_m();
    now_.way_m += way_m;
    since_look_m_ += way_m;
    all_since_look_m_ += std::abs(way_m);
  }
  recent_.push_back({sensed.tick, X_OR_, sensed.imu});
  while (recent_.front().tick + kLatest < sensed.tick) recent_.pop_front();
}

ImuSample TargetOdometry::BeginLook(Tick exposed) {
  exposed_ = recent_.front();
  for (const Moment& moment : recent_) {
    if (std::abs(moment.tick - exposed) < std::abs(exposed_.tick - exposed)) exposed_ = moment;
  }
  X_ER_ = Inverse(exposed_.X_OR) * X_OR_;
  now_.p_RT = X_ER_ * now_.p_RT;
  now_.turned_rad -= X_ER_.heading;
  now_.spread_m2 = Turned(now_.spread_m2, X_ER_.heading);
  return exposed_.imu;
}

void TargetOdometry::EndLook() {
  at_look_ = now_;
  X_OL_ = exposed_.X_OR;
  since_look_m_ = all_since_look_m_ = 0.0;
  now_.p_RT = Inverse(X_ER_) * now_.p_RT;
  now_.turned_rad += X_ER_.heading;
  now_.spread_m2 = Turned(now_.spread_m2, -X_ER_.heading);
}

// The way is that of one arc, or of arcs one way.
void TargetOdometry::Learn(double further_m) {
  if (std::abs(since_look_m_) < all_since_look_m_) return;
  odometry_.Learn(further_m, kTips_m, since_look_m_);
}

bool TargetOdometry::SeeGround(GroundPicture picture) {
  const Pose2 X_LE = Inverse(X_OL_) * exposed_.X_OR;
  GroundMotion motion;
  for (const double share : kShares) {
    if (!ground_at_look_ || motion.found) break;
    const Pose2 X_LE_less{share * X_LE.x, share * X_LE.y, X_LE.heading};
    motion = MotionBetween(*ground_at_look_, picture, Inverse(X_LE_less), kYawSigma_rad);
  }
  ground_at_look_ = std::move(picture);
  if (!motion.found) return false;
  const Pose2 moved = Inverse(motion.X_NB);
  Learn(X_LE.x - moved.x);
  now_ = {motion.X_NB * at_look_.p_RT,
          Turned(at_look_.spread_m2, -moved.heading) + motion.spread_m2,
          at_look_.turned_rad + moved.heading, at_look_.way_m};
  return true;
}

void TargetOdometry::TakeOver(const Vector2d& p_E, double further_m) {
  if (further_m != 0.0) Learn(further_m);
  now_ = {};
  now_.p_RT = p_E;
}

}  // namespace dockyard::rocky7
