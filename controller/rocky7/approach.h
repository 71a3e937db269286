// The tracking loop of Nesnas, Maimone and Das (ICRA 2000), section IV: look, find the target, plan
// arcs to it, drive a part of them, look again, until the point P is on the target. Ours looks
// while it drives, too.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller/imaging/image_request.h"
#include "controller/rocky7/arc_drive.h"
#include "controller/rocky7/escape.h"
#include "controller/rocky7/ground_perception.h"
#include "controller/rocky7/pair_work.h"
#include "controller/rocky7/phases.h"

namespace dockyard::rocky7 {

struct ApproachOptions {
  FrontEnd front_end = FrontEnd::kSandAndStones;
  // The ground ahead is taken to be parallel to the body, as on a slope; else level, by the unit.
  bool ground_as_body = false;
  double image_share = 0.1;    // of the way that is left, then the rover looks
  double least_step_m = 0.03;  // what is left is driven at once when it is no longer than this
  // Of an arc to the target all but the last bit is driven at once, with a look each time it has
  // gone so far; 0: it stands for its looks.
  double look_each_m = 0.0;
  double claim_share = 1.0;  // of the nominal reach, within which the target must be seen
  // The arm rolls to a target so far to either side of the point.
  double arm_aside_m = 0.0;
  OdometryOptions odometry{};
  // The motion since the last look by what both show of the ground, where that tells it.
  bool sees_motion = false;
  bool exposes_for_target = false;  // asks for more light where the target lies in the shade
  bool backs_up = false;            // two arcs where one would be too sharp, and more patience
  int most_stalls = 0;              // see EscapeOptions
  int most_looks = 60;              // then it gives up: its steps are coarser than its reach
  // A target further from the point than this may be unseen for a look; then the way goes on.
  double blind_beyond_m = 1e9;
  int most_misses = 1;  // looks in a row without the target
};

class Approach {
 public:
  Approach(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
           const ApproachOptions& options);

  /// First in each period of kObserve and kDrive: turns the wheels. kArrived at an arc's end.
  Event Move(Phase phase, const SensorFrame& sensed, std::vector<MotorCommand>& motors);
  /// In kObserve: asks for images, and decides by them.
  Event Observe(const SensorFrame& sensed, Commands& commands);
  /// In kDrive: the same while the rover drives. It may stop it.
  void Watch(const SensorFrame& sensed, Commands& commands);
  /// After a grasp, where the target was detected last. It changes no plan.
  TargetSighting Inspect(const StereoImages& images, const SensorFrame& sensed);
  double exposure_stops() const { return stops_; }
  /// The target in R, in plan.
  const Eigen::Vector2d& p_RT() const { return target_.p_RT(); }
  const Belief& belief() const { return belief_; }

 private:
  /// From the point to the target, less what the arm reaches to a side.
  Eigen::Vector2d LeftToTarget() const;
  /// What is driven until the rover rests: all of an arc or a part of it.
  struct DrivenPart {
    Arc part, whole;         // as the rover itself should go; whole: to the target
    bool aimed = false;      // it ends at the target
    bool watched = false;    // image pairs are taken under way
    double imaged_at_m = 0;  // of it, the last time
    int misses = 0;          // image pairs in a row, under way, without the target
  };
  TargetSighting Detect(const StereoImages& images, const SensorFrame& sensed);
  /// Of the body over the ground as it is taken to be.
  void Keep(const TargetSighting& sighting, const ImuSample& attitude);
  Event DecideBy(const TargetSighting& sighting, double yaw_rad);
  Event Decide(double yaw_rad);
  Event Drive(const Arc& way, double yaw_rad);
  Event GiveUp(const std::string& why);
  /// Before the rover backs off: by what its back pair shows.
  Event ObserveBehind(const SensorFrame& sensed, Commands& commands);
  void Tell(const std::string& phase, const std::string& note);
  std::vector<Arc> PathToTarget() const;
  double OffAtEnd() const;
  bool TooDark(const GrayImage& left, const ImuSample& attitude);
  bool MayWatch() const;

  const Nominal nominal_;
  const ApproachOptions options_;
  GroundStereo stereo_;
  GroundMemory memory_;
  ArcDrive drive_;
  TargetOdometry target_;
  ImageRequest request_;
  PairWork work_;
  double stops_ = 0.0;           // off the cameras' own exposure
  int pairs_ = 0, misses_ = 0;   // of images in all; in a row without the target
  Eigen::Vector2d aim_m_{0, 0};  // off the target, as arcs have missed it
  DrivenPart driven_;
  Escape escape_;
  Belief belief_;
};

}  // namespace dockyard::rocky7
