// A rover that starts seated: out of the cone, as far as its mission says, and back to where it may
// see the board.
#include <optional>

#include "controller/axel/drive.h"
#include "controller/axel/machine_impl.h"

namespace dockyard::axel {

// Its mission says that it starts seated, so it knows where it is, and its arm how the ground
// falls.
void AxelMachine::BeginExcursion() {
  senses_.filter().Restart(SeatedFix(nominal_));
  reeled_seated_m_ = senses_.reeled_m();
  rolled_seated_m_ = senses_.rolled_m();
  yaw_seated_rad_ = senses_.yaw_rad();
  const double fall_rad = FallBySeatedArm(nominal_, senses_.elevation_rad());
  outward_tension_n_ = OutwardTension(options_, fall_rad);
}

// In reverse the arm stays ahead, and the tether steadies it. A rover that does not get on goes
// back: how far it was is not for it to claim.
std::optional<Event> AxelMachine::GoOut(double way_m, Commands* commands) {
  const DriveOptions& drive = options_.drive;
  const double out_m =
      WayOut(reeled_seated_m_ - senses_.reeled_m(), rolled_seated_m_ - senses_.rolled_m());
  const double limit_s = drive.patience * way_m / drive.reverse_m_s;
  const bool late = kTickSeconds * static_cast<double>(InPhase()) > limit_s;
  if (late) belief_.note = "does not get out as far as told";
  if (late || out_m >= way_m) return Event::kArrived;
  const double turn_rad_s =
      options_.excursion.yaw_gain_per_s * WrapPi(yaw_seated_rad_ - senses_.yaw_rad());
  CommandWheels(nominal_, {-drive.reverse_m_s, turn_rad_s}, drive.wheel_accel_rad_s2, commands);
  const TetherOptions& tether = options_.tether;
  Spool(commands) = Winch(nominal_, tether.catch_up_m_s, outward_tension_n_, tether.accel_rad_s2);
  // Seated it learns the tether's length, and further out its distance from it.
  senses_.UseTether(tether.taut_share * outward_tension_n_);
  if (std::abs(senses_.pitch_rad()) < Radians(45.0)) arm_.Level(senses_);
  return std::nullopt;
}

void AxelMachine::BeginReturn() {
  const double out_m =
      WayOut(reeled_seated_m_ - senses_.reeled_m(), rolled_seated_m_ - senses_.rolled_m());
  const double back_m = WayBack(out_m, options_.excursion);
  returns_ = back_m > 0.0;
  if (!returns_) return;
  driving_.PlanAhead(senses_, back_m);
  const DriveOptions& drive = options_.drive;
  driving_.Start({drive.approach_m_s, drive.reverse_m_s, drive.steering}, senses_.now());
}

}  // namespace dockyard::axel
