#include "controller/rocky7/mission.h"

#include <algorithm>

#include "controller/motion/limits.h"
#include "controller/rocky7/tipping.h"

namespace dockyard::rocky7 {
namespace {

// Then the scoops are believed. Assumed, 1-10 s and 2-10.
constexpr ImagePatience kInspection{.wait = 3000, .most_asks = 3};

}  // namespace

Mission::Mission(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
                 const ApproachOptions& approach, const MissionOptions& options)
    : nominal_(nominal),
      options_(options),
      approach_(nominal, std::move(tracker), approach),
      grasp_(nominal, approach.ground_as_body),
      work_(nominal.compute_s) {}

void Mission::Tell(const std::string& note) {
  belief_ = approach_.belief();
  belief_.phase = Name(phase_);
  belief_.note = note;
}

void Mission::StepApproach(const SensorFrame& sensed, Commands& commands) {
  On(approach_.Move(phase_, sensed, commands.motors));
  if (phase_ == Phase::kDrive) {
    approach_.Watch(sensed, commands);
  } else {
    On(approach_.Observe(sensed, commands));
  }
  belief_ = approach_.belief();
  if (phase_ != Phase::kDeploy) return;
  if (options_.inspects && TipsWithArmOut(sensed)) {
    On(Event::kFailed);
    Tell("the rover would tip with its arm out");
    return;
  }
  ++tried_;
  grasp_.Start(sensed, options_.inspects, approach_.p_RT().y());
}

bool Mission::TipsWithArmOut(const SensorFrame& sensed) const {
  const std::size_t first = FirstMastMotor(nominal_);
  const MastAngles mast{AngleOf(nominal_, sensed, first), AngleOf(nominal_, sensed, first + 1),
                        AngleOf(nominal_, sensed, first + 2)};
  const std::array<double, 2> level{0.0, -sensed.imu.pitch_rad};
  return TippingMargin(nominal_, sensed.imu, level, mast) < kLeastTippingMargin_m;
}

void Mission::StepGrasp(const SensorFrame& sensed) {
  const Event event = grasp_.Step(phase_, sensed);
  if (event == Event::kMissed) return TryAgain();
  On(event);
  Tell(event == Event::kFailed ? "the arm does not come up" : grasp_.note());
  if (phase_ != Phase::kLifted) return;
  // Sand in the scoops weighs like a stone.
  On(options_.inspects ? Event::kUnsure : Event::kHeld);
  request_ = {};
}

void Mission::TryAgain() {
  On(tried_ < options_.tries ? Event::kMissed : Event::kFailed);
  if (phase_ == Phase::kGivenUp) Tell("the stone is still on the ground");
}

void Mission::Inspect(const SensorFrame& sensed, Commands& commands) {
  if (FrontPair(sensed) && !work_.busy()) {
    request_.asked.reset();
    work_.Begin(sensed);
  }
  if (const auto taken = work_.Done(sensed.tick)) {
    const TargetSighting sighting = approach_.Inspect(*FrontPair(*taken), *taken);
    Tell(sighting.why);
    // The arm weighs no more, so the stone is on the ground wherever it has gone.
    if (sighting.found || grasp_.load() == Load::kNone) return TryAgain();
    if (sighting.gone) return On(Event::kHeld);
  }
  if (work_.busy()) return;
  const RequestState state = StateOf(request_, kInspection, sensed.tick);
  if (state == RequestState::kUnanswered) return On(Event::kHeld);
  if (state == RequestState::kAwaited) return;
  Ask({kFrontLeft, kFrontRight}, sensed.tick, &request_, &commands);
  commands.exposure_stops = approach_.exposure_stops();
  Tell("takes an image pair of the place");
}

Commands Mission::Step(const SensorFrame& sensed) {
  Commands commands;
  commands.motors.resize(nominal_.motors.size());
  if (Approaches(phase_)) StepApproach(sensed, commands);
  if (Grasps(phase_)) StepGrasp(sensed);
  if (phase_ == Phase::kInspect) Inspect(sensed, commands);
  std::copy(grasp_.commands().begin(), grasp_.commands().end(),
            commands.motors.begin() + static_cast<long>(FirstArmMotor(nominal_)));
  belief_.values = approach_.belief().values;
  belief_.values.push_back({"grasps", static_cast<double>(tried_)});
  commands.verdict = VerdictOf(phase_);
  KeepLimits(nominal_.motors, &commands);
  return commands;
}

}  // namespace dockyard::rocky7
