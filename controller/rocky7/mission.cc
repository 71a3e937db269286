#include "controller/rocky7/mission.h"

#include <algorithm>

namespace dockyard::rocky7 {
namespace {

// Cameras that do not answer are asked again after so long, so often; then the scoops are believed.
// Assumed, 1-10 s and 2-10.
constexpr Tick kPeekAgain = 3000;
constexpr int kMostPeeks = 3;

}  // namespace

Mission::Mission(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
                 const ApproachOptions& approach, const MissionOptions& options)
    : nominal_(nominal),
      options_(options),
      approach_(nominal, std::move(tracker), approach),
      grasp_(nominal) {}

void Mission::Tell(const char* phase, const std::string& note) {
  belief_ = approach_.belief();
  belief_.phase = phase;
  belief_.note = note;
}

void Mission::StepApproach(const SensorFrame& sensed, Commands& commands) {
  commands = approach_.Step(sensed);
  belief_ = approach_.belief();
  if (commands.verdict != Verdict::kDone || nominal_.task != Task::kGrasp) {
    verdict_ = commands.verdict;
    return;
  }
  ++tried_;
  grasp_.Start(sensed, options_.peeks);
  phase_ = Phase::kGrasp;
}

void Mission::StepGrasp(const SensorFrame& sensed) {
  Tell(grasp_.phase(), grasp_.note());
  if (!grasp_.lifted()) return;
  if (!options_.peeks || grasp_.load() == Load::kStone) {
    verdict_ = Verdict::kDone;
    return;
  }
  phase_ = Phase::kPeek;
  peeks_ = 0;
  asked_ = sensed.tick - kPeekAgain;
}

void Mission::TryAgain() {
  if (tried_ >= options_.tries) {
    verdict_ = Verdict::kGivenUp;
    return Tell("given_up", "the stone is still on the ground");
  }
  approach_.LookAgain();
  phase_ = Phase::kApproach;
}

void Mission::StepPeek(const SensorFrame& sensed, Commands& commands) {
  if (const auto images = FrontPair(sensed)) {
    const TargetSeen seen = approach_.Peek(*images, sensed);
    Tell("peek", seen.why);
    // The arm weighs no more, so the stone is on the ground wherever it has gone.
    if (seen.found || grasp_.load() == Load::kNone) return TryAgain();
    if (seen.gone) {
      verdict_ = Verdict::kDone;
      return;
    }
    asked_ = sensed.tick - kPeekAgain;
  }
  if (sensed.tick - asked_ < kPeekAgain) return;
  if (++peeks_ > kMostPeeks) {
    verdict_ = Verdict::kDone;
    return;
  }
  commands.take_images = {kFrontLeft, kFrontRight};
  commands.exposure_stops = approach_.exposure_stops();
  asked_ = sensed.tick;
}

Commands Mission::Step(const SensorFrame& sensed) {
  Commands commands;
  commands.motors.resize(nominal_.motors.size());
  const bool acts = verdict_ == Verdict::kUnderWay;
  if (acts && phase_ == Phase::kApproach) StepApproach(sensed, commands);
  const std::vector<MotorCommand> arm = grasp_.Step(sensed);
  std::copy(arm.begin(), arm.end(),
            commands.motors.begin() + static_cast<long>(FirstArmMotor(nominal_)));
  if (acts && phase_ == Phase::kGrasp) StepGrasp(sensed);
  if (acts && phase_ == Phase::kPeek) StepPeek(sensed, commands);
  belief_.values.resize(3);
  belief_.values.push_back({"grasps", static_cast<double>(tried_)});
  commands.verdict = verdict_;
  return commands;
}

}  // namespace dockyard::rocky7
