#include "controller/rocky7/place_mission.h"

#include <algorithm>

#include "controller/base/number_text.h"

namespace dockyard::rocky7 {
namespace {

// "The rover moves away from the target area" (N, IV-B). Assumed, 0.2-1 m.
constexpr double kAway_m = 0.3;

// Larger steps than the paper's. Assumed: 0.15-0.4, 8-20 cm and 0.4-1 m; slip as approach.h has it.
constexpr FaceApproachOptions kOurs{.image_share = 0.3,
                                    .least_step_m = 0.12,
                                    .most_step_m = 0.6,
                                    .odometry = {.turn_by_unit = true, .slip = 0.1},
                                    .exposes_for_target = true,
                                    .corrects = true,
                                    .most_looks = 60,
                                    .most_misses = 4};
// Of the paper's tenths there are 40 on a way of 6 m. Assumed, 60-200.
constexpr int kTenths = 100;
// Assumed, 1-3.
constexpr int kOurTries = 2;

}  // namespace

PlaceMission::PlaceMission(const Nominal& nominal, std::unique_ptr<FaceTracker> tracker,
                           const FaceApproachOptions& options, int tries)
    : nominal_(nominal),
      tries_(tries),
      approach_(nominal, std::move(tracker), options),
      placement_(nominal),
      drive_(nominal),
      mast_(kMastMotorCount) {}

void PlaceMission::Tell(const char* phase, const std::string& note) {
  belief_.phase = phase;
  belief_.note = note;
}

void PlaceMission::End(Verdict verdict, const char* phase, const std::string& note) {
  verdict_ = verdict;
  Tell(phase, note);
}

void PlaceMission::Hold(Commands& commands, const std::vector<MotorCommand>& mast) const {
  std::copy(mast.begin(), mast.end(),
            commands.motors.begin() + static_cast<long>(FirstMastMotor(nominal_)));
}

void PlaceMission::StepApproach(const SensorFrame& sensed, Commands& commands) {
  commands = approach_.Step(sensed);
  mast_.assign(commands.motors.begin() + static_cast<long>(FirstMastMotor(nominal_)),
               commands.motors.end());
  belief_ = approach_.belief();
  if (commands.verdict != Verdict::kUnderWay) verdict_ = commands.verdict;
  if (!approach_.ready()) return;
  ++tried_;
  placement_.Start(approach_.face(), sensed);
  phase_ = Phase::kPlace;
}

void PlaceMission::StepPlace(const SensorFrame& sensed, Commands& commands) {
  mast_ = placement_.Step(sensed);
  Hold(commands, mast_);
  Tell(placement_.phase(), placement_.note());
  switch (placement_.result()) {
    case Placement::Result::kNone:
      return;
    case Placement::Result::kBlocked:
      return End(Verdict::kGivenUp, "given_up", placement_.note());
    case Placement::Result::kMissed:
      if (tried_ >= tries_) return End(Verdict::kGivenUp, "given_up", placement_.note());
      approach_.LookAgain();
      phase_ = Phase::kApproach;
      return;
    case Placement::Result::kPlaced:
      drive_.Start({-kAway_m, 0.0});
      phase_ = Phase::kBackOff;
      Tell("back_off", "moves away");
      return;
  }
}

void PlaceMission::StepBackOff(const SensorFrame& sensed, Commands& commands) {
  commands.motors = drive_.Step(sensed);
  Hold(commands, mast_);
  if (drive_.done()) {
    End(Verdict::kDone, "placed",
        "placed with " + std::to_string(placement_.closed()) + " switches");
  }
}

Commands PlaceMission::Step(const SensorFrame& sensed) {
  Commands commands;
  commands.motors.resize(nominal_.motors.size());
  if (verdict_ != Verdict::kUnderWay) {
    Hold(commands, mast_);
  } else if (phase_ == Phase::kApproach) {
    StepApproach(sensed, commands);
  } else if (phase_ == Phase::kPlace) {
    StepPlace(sensed, commands);
  } else {
    StepBackOff(sensed, commands);
  }
  belief_.values = approach_.belief().values;
  belief_.values.push_back({"placements", static_cast<double>(tried_)});
  belief_.values.push_back({"switches", static_cast<double>(placement_.closed())});
  belief_.values.push_back({"beyond_mm", 1e3 * placement_.beyond_m()});
  commands.verdict = verdict_;
  return commands;
}

std::unique_ptr<Controller> MakeDockyardPlacement(const Nominal& nominal) {
  return std::make_unique<PlaceMission>(nominal, std::make_unique<PatchTracker>(), kOurs,
                                        kOurTries);
}

std::unique_ptr<Controller> MakeNesnas2000Placement(const Nominal& nominal) {
  const FaceApproachOptions options{.image_share = nominal.nesnas.image_share,
                                    .least_step_m = nominal.nesnas.least_step_m,
                                    .most_looks = kTenths};
  return std::make_unique<PlaceMission>(nominal, MakeTopTracker(nominal.nesnas), options, 1);
}

}  // namespace dockyard::rocky7
