#include "controller/axel/tether_pull.h"

#include "controller/axel/drive.h"

namespace dockyard::axel {

void TetherPull::Enter(Stage stage, const Senses& senses) {
  stage_ = stage;
  since_ = senses.now();
  reeled_m_ = senses.reeled_m();
  still_.Reset();
}

// What the tether stretches as the tension changes does not count as help.
bool TetherPull::Step(const Senses& senses, Commands* commands) {
  const TetherOptions& tether = options_.tether;
  const Tick still = still_.Still(senses.now(), senses.reeled_m());
  const bool helped = senses.reeled_m() - reeled_m_ >= tether.helped_m;
  bool stalled = false;
  switch (stage_) {
    case Stage::kGentle:
      if (still >= tether.nudge_after) Enter(Stage::kNudge, senses);
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
  SetWheels(MotorMode::kFree, commands);
  if (stage_ == Stage::kNudge) {
    CommandWheels(nominal_, {tether.tighten_m_s, 0.0}, options_.drive.wheel_accel_rad_s2, commands);
    LimitThrust(nominal_, tether.nudge_thrust_n, commands);
  }
  const double tension_n =
      stage_ == Stage::kHard ? tether.search_tension_n : tether.first_tension_n;
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal_, tether.tighten_m_s, tension_n, tether.accel_rad_s2);
  return stalled;
}

}  // namespace dockyard::axel
