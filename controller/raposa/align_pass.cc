#include "controller/raposa/align_pass.h"

#include <optional>

#include "controller/raposa/way_control.h"

namespace dockyard::raposa {
namespace {

double Lever(const Nominal& nominal) { return -nominal.X_RC.p.x(); }

}  // namespace

AlignPass::AlignPass(const Nominal& nominal, const Sight& sight)
    : options_(nominal.ferreira_motion),
      lost_frames_(nominal.ferreira_vision.lost_frames),
      plan_(PlanAlignment(sight.Guide(), options_.standoff_m, Lever(nominal))),
      visual_turn_(plan_.beta_rad, sight.Guide().bearing_rad,
                   GuideInN(sight.Guide(), Lever(nominal)).norm(), Lever(nominal), options_) {}

Twist AlignPass::Step(Tick now, const Sight& sight, const Twist& last, BeltOdometry* odometry) {
  if (status_ == Status::kByEye) {
    const Twist twist = ByEye(sight, last, odometry);
    if (status_ != Status::kByOdometry) return twist;
  }
  return status_ == Status::kByOdometry ? ByOdometry(now, odometry->X_ON()) : Twist{};
}

Twist AlignPass::ByEye(const Sight& sight, const Twist& last, BeltOdometry* odometry) {
  if (!sight.fresh()) return sight.silent() ? Twist{} : last;
  if (sight.lost() >= lost_frames_) {
    status_ = Status::kLost;
    return {};
  }
  std::optional<VisualTurn::Look> look;
  if (sight.seen().orange) look = VisualTurn::Look{sight.Bearing(), sight.EdgeOfView()};
  if (const std::optional<Twist> twist = visual_turn_.Step(look)) return *twist;
  odometry->Reset(visual_turn_.turned_rad());
  status_ = Status::kByOdometry;
  return {};
}

Twist AlignPass::ByOdometry(Tick now, const Pose2& X_ON) {
  if (part_ == Part::kFirstTurn) {
    const double left_rad = WrapPi(plan_.beta_rad - X_ON.heading);
    if (!Turned(left_rad, options_)) return TurnBy(left_rad, options_);
    part_ = Part::kTravel;
  }
  if (part_ == Part::kTravel) {
    if (!Arrived(plan_, X_ON, options_)) return DriveTo(plan_, X_ON, options_);
    part_ = Part::kLastTurn;
  }
  if (part_ == Part::kLastTurn) {
    const double left_rad = WrapPi(plan_.X_OE.heading - X_ON.heading);
    if (!Turned(left_rad, options_)) return TurnBy(left_rad, options_);
    part_ = Part::kLook;
    stopped_ = now;
  }
  if (static_cast<double>(now - stopped_) * kTickSeconds >= options_.look_s) {
    status_ = Status::kOver;
  }
  return {};
}

}  // namespace dockyard::raposa
