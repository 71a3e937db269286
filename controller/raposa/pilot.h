// Drives RAPOSA onto its pyramid from what its eye tells: looks, manoeuvres to the axis, drives in,
// closes the doors, feels whether they hold the guide, and tries again where they do not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/io/belief.h"
#include "controller/motion/path_follower.h"
#include "controller/raposa/door_feel.h"
#include "controller/raposa/gate_plan.h"
#include "controller/raposa/pyramid_filter.h"
#include "controller/raposa/search.h"

namespace dockyard::raposa {

class Pilot {
 public:
  enum class Phase {
    kLook,      // stands and looks
    kSearch,    // turns to find the guide
    kCreep,     // towards a guide that is too far for a sure pose
    kGlance,    // turns a little to either side of a guide whose square may be out of view
    kBack,      // straight back, away from a guide that is too near for its marks
    kTurn,      // in place, to a leg's heading
    kLeg,       // straight on a leg to the gate
    kFace,      // turns to the pyramid
    kApproach,  // along the axis onto the seat
    kBrake,     // stands before the doors close
    kClose,
    kAjar,   // opens the doors a little and drives on by a nudge
    kProve,  // pulls at the guide
    kRetreat,
    kDocked,
    kGivenUp,
  };

  Pilot(const Nominal& nominal, const DockyardOptions& options);

  /// @param seen   what the eye found in the frame's picture; null: no picture
  /// @param age_s  of its exposure
  Commands Step(const SensorFrame& sensed, const PyramidSeen* seen, double age_s);
  /// What the next picture should show, if anything is known.
  std::optional<PyramidPrior> Prior() const;
  /// Of the camera, down positive.
  double pitch_rad() const;
  const Belief& belief() const { return belief_; }
  Phase phase() const { return phase_; }
  const PyramidFilter& filter() const { return filter_; }

 private:
  void Sense(const SensorFrame& sensed, const PyramidSeen* seen, double age_s);
  Twist Act();
  Twist Look();
  Twist Search();
  Twist Creep();
  Twist Glance();
  Twist Back();
  Twist Turn();
  Twist DriveLeg();
  Twist Face();
  Twist Approach();
  Twist TurnToAside();
  void KeepInView(Twist* twist) const;
  Twist Close();
  Twist Ajar();
  Twist Prove();
  Twist Retreat();
  void Decide();
  void BeginLeg();
  void GoRound();
  void TryAgain(const std::string& why);
  void Enter(Phase phase, const std::string& note);
  Twist TurnTo(double heading_rad, bool* done) const;
  bool ArmPressed() const { return arm_rad_ > options_.leaning_rad; }
  double Gauge() const;
  double For() const { return static_cast<double>(now_ - entered_) * kTickSeconds; }
  bool Looks() const;
  double PressAngle() const;
  double AjarOpening() const;
  bool GuideExpected() const;
  bool MayBeAhead() const;
  double UnseenFor() const { return static_cast<double>(now_ - guide_seen_) * kTickSeconds; }
  void Believe();

  Nominal nominal_;
  DockyardOptions options_;
  PyramidFilter filter_;
  DoorFeel doors_;
  WideningSearch search_;

  Phase phase_ = Phase::kLook;
  Tick now_ = 0, entered_ = 0, guide_seen_ = 0;
  std::optional<std::array<double, 2>> belts_m_;  // left, right, at the last call
  double turned_rad_ = 0.0;                       // by the belts, since the last call
  double driven_m_ = 0.0;                         // of this phase
  std::optional<GuideSeen> guide_, last_guide_;   // of the last picture; the last one seen
  double guide_bearing_rad_ = 0.0;                // of the last one seen, by the belts since
  double unseen_m_ = 0.0;                         // driven since
  double turned_aside_rad_ = 0.0;                 // of this phase
  int fits_ = 0;                                  // pictures with a pose, in this phase
  int fitless_ = 0;                               // in a row without a pose
  std::vector<Leg> legs_;
  std::optional<PathFollower> follower_;
  double arm_rad_ = 0.0, arm_told_rad_ = 0.0, door_open_m_ = 0.0;
  double nudge_m_ = 0.0;
  bool lamps_ = false, pressed_once_ = false;
  int passes_ = 0, backs_ = 0, nudges_ = 0, attempts_ = 0;
  bool glanced_ = false;                             // to the first side, in this phase
  double glance_side_ = 0.0;                         // of the guide in the view: left 1, right -1
  double searched_rad_ = 0.0, away_from_rad_ = 0.0;  // still to turn from a guide without marks
  bool supposed_ = false;                            // no picture told where the pyramid stands
  double sides_seen_ = 0.0;                          // sum of likely sides, of pictures in a row
  double round_side_ = 0.0;                          // it goes round a guide by this way: left 1
  bool other_side_ = false;                          // and went back, by the other
  Twist last_;
  Belief belief_;
};

const char* Name(Pilot::Phase phase);

}  // namespace dockyard::raposa
