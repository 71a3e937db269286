// The tip at the mouth, in it, and on the socket's floor or not.
#include <cmath>
#include <optional>
#include <string>

#include "controller/axel/machine_impl.h"
#include "controller/base/number_text.h"

namespace dockyard::axel {

Event AxelMachine::AtTheMouth() {
  if (driving_.PlanEntry(senses_)) return Event::kGoMate;
  return Misaligned("misaligned at the mouth");
}

Event AxelMachine::Misaligned(const std::string& why) {
  driving_.LearnMouthDrift(driving_.BesideMouthLine(senses_));
  return Recover(Event::kGoRecover, why);
}

std::optional<Event> AxelMachine::Confirm(const SensorFrame& sensed, Commands* commands) {
  if (!seat_check_.Step(sensed, InPhase(), Located(), &judge_, &senses_, commands))
    return std::nullopt;
  SeatKnowledge known{.depth_by_drum_m = reel_in_.DepthByDrum(senses_),
                      .by_image = seat_check_.tip()};
  if (reel_in_.wiggles() > 0) known.taken_up_by_push_m = reel_in_.taken_up_m(senses_);
  SeatRuling ruling = RuleSeat(known, nominal_.seat_depth_m, options_.mate);
  if (seat_check_.slipped_m(senses_) > options_.mate.confirm_slip_m) ruling = SeatRuling::kShort;
  belief_.note = known.by_image
                     ? "tip " + Fixed(known.by_image->depth_m, 3) + " m deep by its picture, arm " +
                           Fixed(Degrees(known.by_image->askew_rad), 1) + " deg aside"
                     : "tip " + Fixed(known.depth_by_drum_m, 3) + " m deep by the drum";
  if (ruling == SeatRuling::kSeated) return Event::kSteady;
  const bool leans =
      known.by_image && std::abs(known.by_image->askew_rad) > options_.mate.lean_limit_rad;
  const bool aside = ruling == SeatRuling::kAskew ||
                     (leans && driving_.recoveries() < options_.mate.short_recoveries);
  const int limit = aside ? options_.mate.lean_wiggles : options_.mate.wiggles;
  if (reel_in_.wiggles() < limit) return Event::kStopsShort;
  // An arm that leans to D's +y has its axle on the other side.
  if (aside)
    driving_.LearnMouthDrift(-(nominal_.arm_length_m - nominal_.seat_depth_m) *
                             std::sin(known.by_image->askew_rad));
  return Recover(Event::kStuck, aside ? "arm stays askew" : "does not go in");
}

}  // namespace dockyard::axel
