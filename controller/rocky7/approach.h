// The tracking loop of Nesnas, Maimone and Das (ICRA 2000), section IV: look, find the target, plan
// arcs to it, drive a part of them, look again, until the point P is on the target. Ours looks
// while it drives, too.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "controller/rocky7/arc_drive.h"
#include "controller/rocky7/ground_eye.h"
#include "controller/rocky7/paths_to_point.h"
#include "controller/rocky7/retreat.h"
#include "controller/rocky7/target_odometry.h"
#include "controller/rocky7/target_tracker.h"

namespace dockyard::rocky7 {

struct ApproachOptions {
  double image_share = 0.1;    // of the way that is left, then the rover looks
  double least_step_m = 0.03;  // what is left is driven at once when it is no longer than this
  // Of an arc to the target all but the last bit is driven at once, with a look each time it has
  // gone so far; 0: it stands for its looks.
  double look_each_m = 0.0;
  double claim_share = 1.0;  // of the nominal reach, within which the target must be seen
  OdometryOptions odometry{};
  // The motion since the last look by what both show of the ground, where that tells it.
  bool sees_motion = false;
  bool exposes_for_target = false;  // asks for more light where the target lies in the shade
  bool backs_up = false;            // two arcs where one would be too sharp, and more patience
  // Near the target, after so many looks that came no nearer, it backs off and comes again by
  // another way: in sand short arcs slip by more than they correct, and a wheel may stand against a
  // stone. 0: never.
  int most_stalls = 0;
  int most_looks = 60;  // then it gives up: its steps are coarser than its reach
  // A target further from the point than this may be unseen for a look; then the way goes on.
  double blind_beyond_m = 1e9;
  int most_misses = 1;  // looks in a row without the target
};

class Approach {
 public:
  Approach(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
           const ApproachOptions& options);

  Commands Step(const SensorFrame& sensed);
  double exposure_stops() const { return stops_; }
  /// A look at where the target was seen last, by a rover that stands. It changes no plan.
  TargetSeen Peek(const StereoImages& images, const SensorFrame& sensed);
  /// Takes a claim back: the target was moved, and is looked for where it was last.
  void LookAgain() { verdict_ = Verdict::kUnderWay; }
  const Belief& belief() const { return belief_; }

 private:
  TargetSeen Look(const StereoImages& images, const SensorFrame& sensed);
  void LookStanding(const StereoImages& images, const SensorFrame& sensed);
  void LookUnderWay(const StereoImages& images, const SensorFrame& sensed);
  void StepStanding(const SensorFrame& sensed, Commands& commands);
  void StepUnderWay(const SensorFrame& sensed, Commands& commands);
  void Ask(const SensorFrame& sensed, Commands& commands);
  bool Waits(const SensorFrame& sensed) const;
  void Decide();
  void Drive(const Arc& way);
  void GiveUp(const std::string& why);
  void Report(const TargetSeen& seen, const ImuSample& attitude);
  void Tell(const std::string& phase, const std::string& note);
  std::vector<Arc> PathToTarget() const;
  double OffAtEnd() const;
  bool TooDark(const GrayImage& left, const ImuSample& attitude);

  const Nominal nominal_;
  const ApproachOptions options_;
  GroundEye eye_;
  ArcDrive drive_;
  std::unique_ptr<TargetTracker> tracker_;
  TargetOdometry target_;
  Verdict verdict_ = Verdict::kUnderWay;
  bool driving_ = false, begun_ = false;
  std::optional<Tick> asked_;
  int asks_ = 0, looks_ = 0, misses_ = 0, misses_under_way_ = 0;
  double stops_ = 0.0;  // off the cameras' own exposure
  double yaw_rad_ = 0.0;
  Eigen::Vector2d aim_m_{0, 0};  // beside the target, as arcs have missed it
  Arc way_, to_target_;          // the present part, as the rover should go it, and the whole arc
  bool aimed_ = false;           // the present part ends at the target
  bool watched_ = false;         // there are looks while it is driven
  double looked_at_m_ = 0.0;     // of it, at the last look
  Retreat retreat_;
  Belief belief_;
};

}  // namespace dockyard::rocky7
