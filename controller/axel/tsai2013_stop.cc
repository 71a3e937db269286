#include "controller/axel/tsai2013_stop.h"

#include <cmath>

#include "controller/axel/drive.h"

namespace dockyard::axel {

Tsai2013Stop::Tsai2013Stop(const Nominal& nominal)
    : nominal_(nominal), options_(nominal.tsai2013), still_(TetherOptions{}.still_m) {}

Tsai2013Stop::Status Tsai2013Stop::Step(const Senses& senses, const SensorFrame& sensed,
                                        ArmLevel* arm, Commands* commands) {
  if (!stopped_at_) stopped_at_ = senses.now();
  switch (part_) {
    case Part::kTighten:
      if (!Taut(senses, senses.now() - *stopped_at_, commands)) return Status::kTightening;
      part_ = std::abs(senses.pitch_rad()) <= options_.look_pitch_rad ? Part::kLook : Part::kLevel;
      return Status::kTightening;
    case Part::kLevel:
      if (Level(senses, arm, commands)) part_ = Part::kLook;
      return Status::kTightening;
    case Part::kLook:
      break;
  }
  return Look(senses, sensed, commands);
}

bool Tsai2013Stop::Taut(const Senses& senses, Tick since_stop, Commands* commands) {
  StandStill(nominal_, {}, since_stop, commands);
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal_, options_.tighten_m_s, options_.taut_n + nominal_.spool_friction_n,
            TetherOptions{}.accel_rad_s2);
  const Tick still = still_.Still(senses.now(), senses.reeled_m());
  const bool waited = since_stop >= DriveOptions{}.stop_time + options_.still_after;
  return (waited && still >= options_.still_after) || since_stop >= options_.tighten_limit;
}

// "The rover can pitch its cameras independent of the rover's motion" (II): with free wheels the
// arm's motor turns the body about the axle.
bool Tsai2013Stop::Level(const Senses& senses, ArmLevel* arm, Commands* commands) {
  if (!levelling_since_) levelling_since_ = senses.now();
  SetWheels(MotorMode::kFree, commands);
  arm->Level(senses);
  const bool level = std::abs(senses.pitch_rad()) <= 2.0 * ArmOptions{}.dead_band_rad;
  return level || senses.now() - *levelling_since_ >= options_.level_limit;
}

Tsai2013Stop::Status Tsai2013Stop::Look(const Senses& senses, const SensorFrame& sensed,
                                        Commands* commands) {
  if (!looking_since_) looking_since_ = senses.now();
  StandStill(nominal_, {}, senses.now() - *looking_since_, commands);
  const GrayImage* left = GrayImageOf(sensed, kLeftCamera);
  const GrayImage* right = GrayImageOf(sensed, kRightCamera);
  // The last ask counts as unanswered a tick after its time.
  const ImagePatience patience{.wait = LookOptions{}.image_limit + 1};
  const bool answered = request_.asked && left && right;
  const RequestState state = StateOf(request_, patience, senses.now());
  if (answered || state == RequestState::kUnanswered) {
    if (answered) images_ = {*left, *right};
    request_ = {};
    looking_since_ = senses.now();
    return answered ? Status::kImages : Status::kNoImages;
  }
  if (state == RequestState::kDue && senses.now() - *looking_since_ >= options_.settle) {
    Ask({kLeftCamera, kRightCamera}, senses.now(), &request_, commands);
  }
  return Status::kLooking;
}

}  // namespace dockyard::axel
