// The tracking loop of Nesnas, Maimone and Das (ICRA 2000), section IV: look, find the target, plan
// arcs to it, drive a part of them, look again, until the point P is on the target.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "controller/rocky7/arc_drive.h"
#include "controller/rocky7/ground_eye.h"
#include "controller/rocky7/paths_to_point.h"
#include "controller/rocky7/retreat.h"
#include "controller/rocky7/target_tracker.h"

namespace dockyard::rocky7 {

struct ApproachOptions {
  double image_share = 0.1;    // of the way that is left, then the rover looks
  double least_step_m = 0.03;  // what is left is driven at once when it is no longer than this
  double claim_share = 1.0;    // of the nominal reach, within which the target must be seen
  // The turn by the inertial unit in place of the wheels: tandem wheels slip aside on an arc, and
  // the rover turns by 83 to 87 % of what they count (docs/rocky7.md).
  bool turn_by_unit = false;
  // The share of its way that the rover slips, as it is taken at first and then learnt from looks.
  // With a start and a stop every 15 cm it is 20 % in sand (docs/rocky7.md). 0: the wheels' counts
  // are believed.
  double slip = 0.0;
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
  void TakeLook(const StereoImages& images, const SensorFrame& sensed);
  void Decide();
  void Drive(const Arc& way);
  void GiveUp(const std::string& why);
  void Report(const TargetSeen& seen, const ImuSample& attitude);
  void Tell(const std::string& phase, const std::string& note);
  void TakeOver(const TargetSeen& seen);
  std::vector<Arc> PathToTarget() const;
  Pose2 Moved();
  bool TooDark(const GrayImage& left, const ImuSample& attitude);
  void LearnSlip(const TargetSeen& seen);
  double& SlipOf(double way_m) { return slip_[way_m < 0.0 ? 1 : 0]; }

  const Nominal nominal_;
  const ApproachOptions options_;
  GroundEye eye_;
  ArcDrive drive_;
  std::unique_ptr<TargetTracker> tracker_;
  Verdict verdict_ = Verdict::kUnderWay;
  bool driving_ = false, begun_ = false;
  std::optional<Tick> asked_;
  int asks_ = 0, looks_ = 0, misses_ = 0;
  Eigen::Vector2d p_RT_{0, 0};    // the target in R's plan, odometry since the last look included
  double stops_ = 0.0;            // off the cameras' own exposure
  std::array<double, 2> slip_{};  // as learnt, ahead and back
  Eigen::Matrix2d spread_m2_ = Eigen::Matrix2d::Zero();  // of odometry, since then
  double turned_rad_ = 0.0;  // by odometry, since the look that found the target last
  double yaw_rad_ = 0.0, yaw_at_start_rad_ = 0.0;  // now; of the present arc
  double way_m_ = 0.0;           // driven since the target was found or guessed last
  Eigen::Vector2d aim_m_{0, 0};  // beside the target, as arcs have missed it
  bool aimed_ = false;           // the present arc leads to the target
  Retreat retreat_;
  Pose2 moved_before_;  // of the present arc, as far as it is counted in p_RT_
  Belief belief_;
};

}  // namespace dockyard::rocky7
