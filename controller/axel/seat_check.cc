#include "controller/axel/seat_check.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/moving_looks.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {

void SeatCheck::Begin() {
  still_.Reset();
  request_ = {};
  braked_.reset();
  took_image_ = false;
  tip_.reset();
  straighten_.reset();
  taut_from_.reset();
  again_.reset();
}

double SeatCheck::slipped_m(const Senses& senses) const {
  return std::abs(senses.reeled_m() - braked_->reeled_m);
}

MotorCommand SeatCheck::DrawnTaut(const Senses& senses) const {
  const MateOptions& mate = options_.mate;
  return Winch(nominal_, mate.taut_m_s, SeatTension(options_, senses),
               options_.tether.accel_rad_s2);
}

bool SeatCheck::Step(const SensorFrame& sensed, Tick in_phase, const Locator& locate,
                     SightingJudge* judge, Senses* senses, Commands* commands) {
  StandStill(nominal_, options_.drive, in_phase, commands);
  if (!Steadied(*senses, in_phase, commands)) return false;
  took_image_ = took_image_ || TookImage(sensed, locate, judge, senses, commands);
  const bool waited = senses->now() - braked_->since >= options_.mate.confirm_time;
  if (!took_image_ || !waited) return false;
  if (!tip_ || tip_->depth_m < nominal_.seat_depth_m - options_.mate.seat_margin_m) return true;
  if (!straighten_) straighten_.emplace(tip_->askew_rad);
  if (!straighten_->Step(nominal_, *senses, options_.mate, commands)) return false;
  if (!TautAgain(*senses, commands)) return false;
  tip_->askew_rad = straighten_->LeanLeft(*senses);
  return true;
}

bool SeatCheck::Steadied(const Senses& senses, Tick in_phase, Commands* commands) {
  if (braked_) return true;
  CommandOf(commands, Motor::kSpool) = DrawnTaut(senses);
  const bool waited = in_phase >= options_.drive.stop_time + options_.tether.taut_after;
  const Tick still = still_.Still(senses.now(), senses.reeled_m());
  const bool still_enough = waited && still >= options_.tether.taut_after;
  if (!still_enough && in_phase < options_.mate.taut_limit) return false;
  braked_ = Braked{.since = senses.now(), .reeled_m = senses.reeled_m()};
  CommandOf(commands, Motor::kSpool) = {};
  return true;
}

// An image that does not come is not asked for again: the drum then tells the depth.
bool SeatCheck::TookImage(const SensorFrame& sensed, const Locator& locate, SightingJudge* judge,
                          Senses* senses, Commands* commands) {
  if (const std::optional<StereoImages> images = AnswerTo(request_, sensed)) {
    const LocateOutput located = locate(*images, HintsFrom(*senses));
    if (!located.sighting) return true;
    judge->NewStop();
    judge->Judge(*located.sighting, senses);
    const Pose3& X_RB = located.sighting->X_RB;
    const TipSeen tip{DepthBySighting(nominal_, X_RB, senses->arm_rad()),
                      AskewBySighting(nominal_, X_RB, senses->arm_rad())};
    // Deeper than the floor is nonsense.
    if (tip.depth_m <= nominal_.seat_depth_m + options_.mate.over_reel_m) tip_ = tip;
    return true;
  }
  const ImagePatience patience{.wait = options_.mate.picture_limit};
  const RequestState state = StateOf(request_, patience, senses->now());
  if (state == RequestState::kDue)
    Ask({kLeftCamera, kRightCamera}, senses->now(), &request_, commands);
  return state == RequestState::kUnanswered;
}

// The turn that straightens the arm may push the tip in and leave the tether slack.
bool SeatCheck::TautAgain(const Senses& senses, Commands* commands) {
  if (!straighten_->turned()) return true;
  const Tick now = senses.now();
  if (!taut_from_) {
    taut_from_ = now;
    still_.Reset();
  }
  const Tick still = still_.Still(now, senses.reeled_m());
  const bool taut = std::min(still, now - *taut_from_) >= options_.tether.taut_after;
  if (!again_ && !taut && now - *taut_from_ < options_.mate.taut_limit) {
    CommandOf(commands, Motor::kSpool) = DrawnTaut(senses);
    return false;
  }
  if (!again_) {
    again_ = now;
    braked_->reeled_m = senses.reeled_m();
  }
  return now - *again_ >= options_.mate.confirm_time;
}

}  // namespace dockyard::axel
