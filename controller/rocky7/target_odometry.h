// Where a target on the ground is while the rover drives: by odometry since the last detection, and
// at an image pair by the motion that it and the last pair show of the ground.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/imaging/past_motion.h"
#include "controller/io/sensors.h"
#include "controller/motion/arcs.h"
#include "controller/rocky7/arc_drive.h"
#include "controller/rocky7/odometry.h"
#include "controller/rocky7/target_tracker.h"

namespace dockyard::rocky7 {

/// A target in R's plan, and what odometry has added since it was detected.
struct OdometryTarget {
  Eigen::Vector2d p_RT{0, 0};
  Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();
  double turned_rad = 0.0, driven_m = 0.0;

  /// For the tracker.
  Predicted predicted() const;
};
/// In the axes of N. The rover turned by this from one to the other.
OdometryTarget InFrame(const OdometryTarget& target, const Pose2& X_NR, double turned_rad);

/// What odometry says of the time of an exposure. E: R then.
struct ExposurePrior {
  ImuSample attitude;
  OdometryTarget target;  // in E
  OdometryTarget before;  // in R at the last image pair B, as that left it
  Pose2 X_BE, X_OE, X_ER;
};

/// What perception makes of a prior and an image pair.
struct GroundDetection {
  TargetSighting sighting{};
  OdometryTarget predicted{};   // in E
  std::optional<Pose2> X_BE{};  // where the pairs show the motion between them
};

class TargetOdometry {
 public:
  explicit TargetOdometry(const OdometryOptions& options) : odometry_(options) {}

  const Eigen::Vector2d& p_RT() const { return now_.p_RT; }
  /// So that the rover itself, which slips, drives this arc.
  /// It may be sharper than its wheels steer.
  Arc AgainstSlip(const Arc& arc) const;
  /// In R: where a distance from here would end off where its arcs lead, by the slope.
  Eigen::Vector2d DriftOn(double distance_m) const;

  /// Each period; `drive` has read these sensors, if it drives.
  void Step(const ArcDrive& drive, bool drives, const SensorFrame& sensed);
  void BeginArc(const Arc& arc, double yaw_rad);

  ExposurePrior At(Tick exposed) const;
  /// Goes on from a detection, and learns the slip from it.
  void Take(const ExposurePrior& prior, const GroundDetection& detection);

 private:
  void Learn(double further_m);

  Odometry odometry_;
  OdometryTarget now_;
  Pose2 X_OR_;             // O: where the rover was switched on
  PastMotion past_{3000};  // images come no later; assumed, 1-5 s
  double driven_m_ = 0.0;  // of the present arc
  OdometryTarget before_;
  Pose2 X_OB_;
  double since_m_ = 0.0, all_since_m_ = 0.0;  // driven since B, signed and not
  double rolled_m_ = 0.0;                     // driven since B, times the sine of the roll
  double roll_rad_ = 0.0;
};

}  // namespace dockyard::rocky7
