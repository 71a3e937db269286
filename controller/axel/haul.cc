#include "controller/axel/haul.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/drive.h"
#include "controller/axel/station_hold.h"

namespace dockyard::axel {
namespace {

// The socket lays the arm along its axis, whatever the axle's height, which the soil decides.
double SeatedElevation(const Nominal& nominal) { return std::asin(nominal.X_DB.R.col(2).z()); }

}  // namespace

Hold JudgePush(const Push& push, double elevation_rad, const Nominal& nominal,
               const HaulOptions& options) {
  // Too low is a tip on the ground. Too high may be an arm wedged askew in the throat; on sand the
  // pushes dig the wheels in, and a seated arm stands as high. There the rover cannot tell.
  if (std::abs(elevation_rad - SeatedElevation(nominal)) > options.elevation_rad)
    return Hold::kLoose;
  // A rover that comes in askew is turned into line by the cone on its way.
  if (push.taken_up_m >= options.firm_m) return Hold::kDeeper;
  const bool turns = push.turned_rad > options.held_share * push.commanded_rad;
  return turns ? Hold::kLoose : Hold::kHeld;
}

BoardFix SeatedFix(const Nominal& nominal) {
  const double x_m =
      nominal.arm_length_m * std::cos(SeatedElevation(nominal)) - nominal.seat_depth_m;
  const Eigen::Vector2d to = nominal.X_DB.p.head<2>() - Eigen::Vector2d(x_m, 0.0);
  return {to.norm(), WrapPi(std::atan2(to.y(), to.x()) - kPi), kPi};
}

void Haul::Enter(Stage stage, const Senses& senses) {
  slide_.NextStage(senses);
  stage_ = stage;
  entered_ = senses.now();
  reeled_m_ = senses.reeled_m();
  yaw_rad_ = senses.yaw_rad();
  leftmost_rad_ = rightmost_rad_ = 0.0;
  still_.Reset();
}

void Haul::Begin(const Senses& senses) {
  pushes_ = 0;
  pull_.Begin(senses);
  Enter(Stage::kDraw, senses);
}

Haul::Status Haul::Step(const Senses& senses, Commands* commands) {
  const TetherOptions& tether = options_.tether;
  const HaulOptions& reel_in = options_.haul;
  SetWheels(MotorMode::kFree, commands);
  const Tick since = senses.now() - entered_;
  const bool stalled = still_.Still(senses.now(), senses.reeled_m()) >= options_.mate.stuck_after;
  MotorCommand& spool = commands->motors[static_cast<std::size_t>(Motor::kSpool)];
  if (stage_ == Stage::kDraw) {
    const TetherPull::Status pull = pull_.Step(senses, commands);
    if (senses.reeled_m() - reeled_m_ > options_.search.reel_limit_m) return Status::kLoose;
    if (pull != TetherPull::Status::kPulls) Enter(Stage::kAlign, senses);
    slide_.Begin(senses);
    return Status::kUnderWay;
  }
  if (stage_ == Stage::kEase) {
    spool =
        Winch(nominal_, options_.mate.taut_m_s, SeatTension(options_, senses), tether.accel_rad_s2);
    return since >= reel_in.ease_time ? Status::kHeld : Status::kUnderWay;
  }
  if (slide_.Slides(senses)) return Status::kLoose;
  const bool gently = stage_ == Stage::kAlign;
  const double align_n =
      std::min(reel_in.align_tension_n, SurePull(nominal_, options_.hold, senses));
  spool = Winch(nominal_, tether.reel_m_s, gently ? align_n : tether.reel_tension_n,
                tether.accel_rad_s2);
  if (stage_ == Stage::kPull) {
    if (stalled) Enter(Stage::kPush, senses);
    return Status::kUnderWay;
  }
  if (since >= 4 * reel_in.quarter) return JudgeHere(senses);
  const double turned_rad = WrapPi(senses.yaw_rad() - yaw_rad_);
  leftmost_rad_ = std::max(leftmost_rad_, turned_rad);
  rightmost_rad_ = std::min(rightmost_rad_, turned_rad);
  // To the left, twice as long to the right, and back.
  const double side = since < reel_in.quarter || since >= 3 * reel_in.quarter ? 1.0 : -1.0;
  CommandWheels(nominal_, {0.0, side * reel_in.push_rad_s}, reel_in.push_accel_rad_s2, commands);
  return Status::kUnderWay;
}

Haul::Status Haul::JudgeHere(const Senses& senses) {
  if (stage_ == Stage::kAlign) {
    const bool helped = senses.reeled_m() - reeled_m_ >= options_.haul.firm_m;
    Enter(helped && ++pushes_ < options_.haul.pushes ? Stage::kAlign : Stage::kPull, senses);
    if (stage_ == Stage::kPull) pushes_ = 0;
    return Status::kUnderWay;
  }
  const Push push{
      2.0 * options_.haul.push_rad_s * kTickSeconds * static_cast<double>(options_.haul.quarter),
      leftmost_rad_ - rightmost_rad_, senses.reeled_m() - reeled_m_};
  switch (JudgePush(push, senses.elevation_rad(), nominal_, options_.haul)) {
    case Hold::kHeld:
      Enter(Stage::kEase, senses);
      return Status::kUnderWay;
    case Hold::kLoose:
      return Status::kLoose;
    case Hold::kDeeper:
      break;
  }
  // Each time that the push helped it may help again.
  if (++pushes_ >= options_.haul.pushes) return Status::kLoose;
  Enter(Stage::kPush, senses);
  return Status::kUnderWay;
}

}  // namespace dockyard::axel
