#include "controller/rocky7/place_mission.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/limits.h"
#include "controller/rocky7/tipping.h"

namespace dockyard::rocky7 {
namespace {

// "The rover moves away from the target area" (N, IV-B). Assumed, 0.2-1 m.
constexpr double kAway_m = 0.3;

// Larger steps than the paper's. Assumed: 0.15-0.4, 8-20 cm and 0.4-1 m, 4-8 and 1-3 misses; slip
// as approach.h has it.
constexpr FaceApproachOptions kOurs{.learns_slope = true,
                                    .image_share = 0.3,
                                    .least_step_m = 0.12,
                                    .most_step_m = 0.6,
                                    .odometry = {.turn_by_unit = true, .slip = 0.1, .drifts = true},
                                    .exposes_for_target = true,
                                    .corrects = true,
                                    .most_looks = 60,
                                    .most_misses = 6,
                                    .blind_after = 2};
// Of the paper's tenths there are 40 on a way of 6 m. Assumed, 60-200.
constexpr int kTenths = 100;
// Assumed, 1-3.
constexpr int kOurTries = 2;

}  // namespace

PlaceMission::PlaceMission(const Nominal& nominal, std::unique_ptr<FaceTracker> tracker,
                           const FaceApproachOptions& options, int tries)
    : nominal_(nominal),
      tries_(tries),
      keeps_upright_(options.corrects),
      approach_(nominal, std::move(tracker), options),
      placement_(nominal),
      drive_(nominal),
      mast_(kMastMotorCount) {}

void PlaceMission::Tell(const char* phase, const std::string& note) {
  belief_.phase = phase;
  belief_.note = note;
}

void PlaceMission::StepApproach(const SensorFrame& sensed, Commands& commands) {
  if (phase_ == Phase::kDrive) On(approach_.Drive(sensed, commands.motors));
  if (phase_ == Phase::kAim) On(approach_.Aim(sensed));
  if (phase_ == Phase::kObserve) On(approach_.Observe(sensed, commands));
  mast_ = approach_.mast_commands();
  belief_ = approach_.belief();
  if (phase_ != Phase::kUnfold) return;
  if (keeps_upright_ && TipsWithMastOut(sensed)) {
    On(Event::kFailed);
    Tell(Name(phase_), "the rover would tip with its mast out");
    return;
  }
  ++tried_;
  placement_.Start(approach_.face(), sensed);
}

// With both links level towards the face.
bool PlaceMission::TipsWithMastOut(const SensorFrame& sensed) const {
  const Eigen::Vector2d to = (approach_.face().p_RT - nominal_.mast.p_RM).head<2>();
  const std::size_t first = FirstArmMotor(nominal_);
  const std::array<double, 2> arm{AngleOf(nominal_, sensed, first),
                                  AngleOf(nominal_, sensed, first + 1)};
  const MastAngles out{std::atan2(to.y(), to.x()), 0.0, 0.0};
  return TippingMargin(nominal_, sensed.imu, arm, out) < kLeastTippingMargin_m;
}

void PlaceMission::StepPlace(const SensorFrame& sensed) {
  const bool stows = phase_ == Phase::kStow;
  Event event = placement_.Step(phase_, sensed);
  if (stows && event == Event::kMissed && tried_ >= tries_) event = Event::kFailed;
  On(event);
  mast_ = placement_.commands();
  Tell(Name(phase_ == Phase::kAim ? Phase::kStow : phase_), placement_.note());
  if (phase_ != Phase::kBackOff) return;
  drive_.Start({-kAway_m, 0.0});
  belief_.note = "moves away";
}

void PlaceMission::StepBackOff(const SensorFrame& sensed, Commands& commands) {
  commands.motors = drive_.Step(sensed);
  if (!drive_.done()) return;
  On(Event::kArrived);
  Tell("placed", "placed with " + std::to_string(placement_.closed()) + " switches");
}

Commands PlaceMission::Step(const SensorFrame& sensed) {
  Commands commands;
  commands.motors.resize(nominal_.motors.size());
  if (Approaches(phase_)) {
    StepApproach(sensed, commands);
  } else if (Places(phase_)) {
    StepPlace(sensed);
  } else if (phase_ == Phase::kBackOff) {
    StepBackOff(sensed, commands);
  }
  std::copy(mast_.begin(), mast_.end(),
            commands.motors.begin() + static_cast<long>(FirstMastMotor(nominal_)));
  belief_.values = approach_.belief().values;
  belief_.values.push_back({"placements", static_cast<double>(tried_)});
  belief_.values.push_back({"switches", static_cast<double>(placement_.closed())});
  belief_.values.push_back({"beyond_mm", 1e3 * placement_.beyond_m()});
  commands.verdict = VerdictOf(phase_);
  KeepLimits(nominal_.motors, &commands);
  return commands;
}

std::unique_ptr<Controller> MakeDockyardPlacement(const Nominal& nominal) {
  return std::make_unique<PlaceMission>(nominal, std::make_unique<PatchTracker>(), kOurs,
                                        kOurTries);
}

std::unique_ptr<Controller> MakeNesnas2000Placement(const Nominal& nominal) {
  const FaceApproachOptions options{.front_end = nominal.nesnas.front_end,
                                    .image_share = nominal.nesnas.image_share,
                                    .least_step_m = nominal.nesnas.least_step_m,
                                    .most_looks = kTenths};
  return std::make_unique<PlaceMission>(nominal, MakeTopTracker(nominal.nesnas), options, 1);
}

}  // namespace dockyard::rocky7
