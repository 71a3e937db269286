// Where a target on the ground is while the rover drives: by odometry since the last look, and at a
// look by what it and the last one show of the ground.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "controller/io/sensors.h"
#include "controller/motion/arcs.h"
#include "controller/rocky7/arc_drive.h"
#include "controller/rocky7/odometry.h"
#include "controller/rocky7/target_tracker.h"
#include "controller/stereo/ground_motion.h"

namespace dockyard::rocky7 {

class TargetOdometry {
 public:
  explicit TargetOdometry(const OdometryOptions& options) : odometry_(options) {}

  /// In R's plan.
  const Eigen::Vector2d& p_RT() const { return now_.p_RT; }
  /// For the tracker, in E.
  Predicted predicted() const;
  /// So that the rover itself, which slips, goes the way.
  /// It may be sharper than its wheels steer.
  Arc AgainstSlip(const Arc& way) const;

  /// Each period; `drive` has read these sensors, if it drives.
  void Step(const ArcDrive& drive, bool drives, const SensorFrame& sensed);
  void BeginArc(const Arc& arc, double yaw_rad);

  /// A look: all is that of the picture's exposure until EndLook(). Returns the attitude then.
  ImuSample BeginLook(Tick exposed);
  /// Puts what the ground shows in place of odometry since the last look that called it. False
  /// where it tells nothing.
  bool SeeGround(GroundPicture picture);
  /// The target was found or guessed. `further_m` as TargetSeen has it, where SeeGround() told
  /// nothing.
  void TakeOver(const Eigen::Vector2d& p_E, double further_m);
  void EndLook();

 private:
  struct Target {
    Eigen::Vector2d p_RT{0, 0};
    Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();  // by odometry, since it was seen
    double turned_rad = 0.0, way_m = 0.0;                 // likewise
  };
  struct Moment {
    Tick tick = 0;
    Pose2 X_OR;  // O: where the rover was switched on
    ImuSample imu;
  };
  void Learn(double further_m);

  Odometry odometry_;
  Target now_;
  Pose2 X_OR_;
  std::deque<Moment> recent_;
  double driven_m_ = 0.0;                               // of the present arc
  Moment exposed_;                                      // of the present look
  Pose2 X_ER_;                                          // since then
  Target at_look_;                                      // as it was left by the last look
  Pose2 X_OL_;                                          // R then
  double since_look_m_ = 0.0, all_since_look_m_ = 0.0;  // ways, signed and not
  std::optional<GroundPicture> ground_at_look_;
};

}  // namespace dockyard::rocky7
