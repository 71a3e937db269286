#include "controller/axel/tether_pull.h"

#include <algorithm>

#include "controller/axel/drive.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {
namespace {

// With less of the first tension wheels do not roll freely. Assumed, 0.8-1.
constexpr double kGentleShare = 0.9;
// A rover that has rolled back by this is drawn backwards. Assumed, 0.5-3 cm.
constexpr double kBackwards_m = 0.01;

}  // namespace

void TetherPull::Enter(Stage stage, const Senses& senses) {
  stage_ = stage;
  since_ = senses.now();
  slide_.NextStage(senses);
  reeled_m_ = senses.reeled_m();
  still_.Reset();
}

void TetherPull::Begin(const Senses& senses) {
  Enter(Stage::kGentle, senses);
  slide_.Begin(senses);
  rolled_m_ = senses.rolled_m();
}

// What the tether stretches as the tension changes does not count as help. The wheels push what the
// station does not bear of a pull.
TetherPull::Status TetherPull::Step(const Senses& senses, Commands* commands) {
  const TetherOptions& tether = options_.tether;
  const Tick still = still_.Still(senses.now(), senses.reeled_m());
  const bool helped = senses.reeled_m() - reeled_m_ >= tether.helped_m;
  const double most_n = std::min(most_n_, SurePull(nominal_, options_.hold, senses));
  const bool too_gentle = most_n < kGentleShare * tether.first_tension_n;
  bool stalled = false;
  switch (stage_) {
    case Stage::kGentle:
      if (still >= tether.nudge_after) slide_.Stalled(senses);
      if (too_gentle || still >= tether.nudge_after) Enter(Stage::kNudge, senses);
      break;
    case Stage::kNudge:
      if (helped) {
        Enter(Stage::kGentle, senses);
      } else if (senses.now() - since_ >= tether.nudge_time) {
        Enter(Stage::kHard, senses);
      }
      break;
    case Stage::kHard:
      if (helped) {
        Enter(Stage::kGentle, senses);
      } else {
        stalled = still >= options_.mate.stuck_after;
      }
      break;
  }
  const bool hard = stage_ == Stage::kHard;
  const double wanted_n = hard ? tether.search_tension_n : tether.first_tension_n;
  const double tension_n = std::min(wanted_n, most_n);
  const double thrust_n = tether.nudge_thrust_n + wanted_n - tension_n;
  SetWheels(MotorMode::kFree, commands);
  if (stage_ == Stage::kNudge || (hard && tension_n < wanted_n)) {
    // A tether from behind draws the rover backwards.
    const bool back = senses.rolled_m() < rolled_m_ - kBackwards_m;
    CommandWheels(nominal_, {back ? -tether.tighten_m_s : tether.tighten_m_s, 0.0},
                  options_.drive.wheel_accel_rad_s2, commands);
    LimitThrust(nominal_, thrust_n, commands);
  }
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal_, tether.tighten_m_s, tension_n, tether.accel_rad_s2);
  if (slide_.Slides(senses)) {
    slid_ = true;
    if (tension_n <= options_.hold.least_pull_n) return Status::kStationSlides;
    most_n_ = std::max(options_.hold.least_pull_n, options_.hold.weaker * tension_n);
    Begin(senses);
  }
  return stalled ? Status::kStalls : Status::kPulls;
}

}  // namespace dockyard::axel
