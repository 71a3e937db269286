#include "controller/rocky7/escape.h"

#include "controller/rocky7/ground_attitude.h"
#include "controller/rocky7/place_plan.h"

namespace dockyard::rocky7 {
namespace {

// Of the back pair. Assumed, 1-10 s and 1-5.
constexpr ImagePatience kBehind{.wait = 3000, .most_asks = 3};

}  // namespace

Escape::Escape(const Nominal& nominal, const EscapeOptions& options)
    : nominal_(nominal), options_(options), behind_(nominal), work_(nominal.compute_s) {}

bool Escape::Decide(double off_m) {
  if (options_.most_stalls == 0) return false;
  if (retreat_.HasArcs()) return true;
  if (!retreat_.Decide(off_m, options_.near_m, options_.most_stalls)) return false;
  awaits_pair_ = true;
  return true;
}

void Escape::Observe(const SensorFrame& sensed, Commands& commands) {
  if (BackPair(sensed) && !work_.busy()) {
    request_ = {};
    work_.Begin(sensed);
  }
  if (const auto taken = work_.Done(sensed.tick)) {
    const ImuSample attitude = AgainstGround(taken->imu, options_.ground_as_body);
    retreat_.KeepOff(nominal_.plan, DiscsOf(behind_.Obstacles(*BackPair(*taken), attitude)));
    awaits_pair_ = false;
    return;
  }
  if (work_.busy()) return;
  const RequestState state = StateOf(request_, kBehind, sensed.tick);
  if (state == RequestState::kDue) Ask({kBackLeft, kBackRight}, sensed.tick, &request_, &commands);
  if (state != RequestState::kUnanswered) return;
  request_ = {};
  awaits_pair_ = false;
}

}  // namespace dockyard::rocky7
