// Under way: image pairs that are not blurred, located where they were exposed and carried to now.
#include <optional>

#include "controller/axel/machine_impl.h"

namespace dockyard::axel {

void AxelMachine::LookUnderWay(const SensorFrame& sensed, Commands* commands) {
  if (!nominal_.vision.while_driving) return;
  looks_.Remember(senses_);
  const std::optional<SinceExposure> since = looks_.Answered(sensed, senses_);
  const std::optional<StereoImages> images = since ? PairOf(sensed) : std::nullopt;
  if (images) {
    LocateOutput seen = perception_.Locate(*images, HintsThen(senses_, *since));
    CarryToNow(*since, options_.noise, &seen);
    Tell(seen.report);
    const bool taken = seen.sighting && judge_.JudgeUnderWay(*seen.sighting, &senses_);
    if (taken) {
      perception_.camera_turn.Take(*seen.sighting);
      looks_.Accepted(*ExposedAt(sensed));
      belief_.note = "board detected on a leg";
    } else if (seen.sighting) {
      RuleOut("contradicts dead reckoning on a leg", &belief_);
    }
  }
  const Pose2 X_DR = senses_.pose();
  const PlanGeometry& geometry = driving_.geometry();
  const double range_m = (geometry.p_DB - Eigen::Vector2d(X_DR.x, X_DR.y)).norm();
  const bool sees = SeesBoard(geometry, options_.look, X_DR) && !driving_.paused() &&
                    range_m < options_.look.max_range_m;
  if (looks_.Asks(senses_, driving_.left_m() <= options_.moving.end_m, sees, range_m)) {
    commands->take_images = {kLeftCamera, kRightCamera};
  }
}

// A leg that ends as planned, in sight of the board a moment ago, needs no stop before the next.
bool AxelMachine::GoesOn(LegDriver::Status status) const {
  const bool to_axis = phase_ == Phase::kApproach || phase_ == Phase::kAlign;
  return to_axis && status == LegDriver::Status::kArrived && looks_.Fresh(senses_.now()) &&
         driving_.legs() < options_.limit.plans;
}

}  // namespace dockyard::axel
