#include "controller/axel/open_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/axel/odometry.h"
#include "controller/base/check.h"

namespace dockyard::axel {
namespace {

// A wheel within this of its target has come to the end of its profile.
constexpr double kThere_rad = 0.01;
// A motor that stays has a profile, too: this share of the faster wheel's.
constexpr double kLeastShare = 1e-6;

}  // namespace

ArcMoves MovesOf(const Nominal& nominal, const OpenLoopOptions& options, const Arc& arc,
                 double shorten_m) {
  const double aside_m = 0.5 * nominal.track_m * arc.turn_rad;
  ArcMoves moves;
  moves.left_rad = (arc.length_m - aside_m) / nominal.wheel_radius_m;
  moves.right_rad = (arc.length_m + aside_m) / nominal.wheel_radius_m;
  moves.spool_rad = shorten_m / nominal.drum_radius_m;
  const double longest = std::max(std::abs(moves.left_rad), std::abs(moves.right_rad));
  const double speed = options.speed_m_s / nominal.wheel_radius_m;
  const double ramp_s = speed / options.wheel_accel_rad_s2;
  moves.seconds = longest >= speed * ramp_s ? longest / speed + ramp_s
                                            : 2.0 * std::sqrt(longest / options.wheel_accel_rad_s2);
  return moves;
}

OpenLoopArcs::OpenLoopArcs(const Nominal& nominal, const OpenLoopOptions& options,
                           std::vector<Arc> arcs, std::vector<double> shorten_m)
    : nominal_(nominal),
      options_(options),
      arcs_(std::move(arcs)),
      shorten_m_(std::move(shorten_m)) {
  DOCKYARD_CHECK(arcs_.size() == shorten_m_.size() && options.speed_m_s > 0.0);
}

void OpenLoopArcs::Begin(const SensorFrame& sensed) {
  const ArcMoves moves = MovesOf(nominal_, options_, arcs_[current_], shorten_m_[current_]);
  const double longest = std::max(std::abs(moves.left_rad), std::abs(moves.right_rad));
  const auto Set = [&](Motor motor, double turn_rad) {
    const auto i = static_cast<std::size_t>(motor);
    const double share = std::max(kLeastShare, longest > 0.0 ? std::abs(turn_rad) / longest : 0.0);
    move_[i] = {.mode = MotorMode::kPosition,
                .target = MotorAngle(nominal_, sensed, motor) + turn_rad,
                .speed_limit_rad_s = share * options_.speed_m_s / nominal_.wheel_radius_m,
                .accel_rad_s2 = share * options_.wheel_accel_rad_s2,
                .current_limit_a = nominal_.motors[i].max_current_a};
  };
  Set(Motor::kLeftWheel, moves.left_rad);
  Set(Motor::kRightWheel, moves.right_rad);
  Set(Motor::kSpool, moves.spool_rad);
  const auto InTicks = [](double seconds) { return static_cast<Tick>(seconds / kTickSeconds); };
  until_ = sensed.tick + InTicks(moves.seconds);
  latest_ = sensed.tick + InTicks(moves.seconds * options_.patience) + options_.lag;
  begun_ = true;
}

bool OpenLoopArcs::WheelsThere(const SensorFrame& sensed) const {
  for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
    const double left =
        move_[static_cast<std::size_t>(wheel)].target - MotorAngle(nominal_, sensed, wheel);
    if (std::abs(left) > kThere_rad) return false;
  }
  return true;
}

bool OpenLoopArcs::Drive(const SensorFrame& sensed, Commands* commands) {
  if (current_ >= arcs_.size()) return true;
  if (!begun_) Begin(sensed);
  for (const Motor motor : {Motor::kLeftWheel, Motor::kRightWheel, Motor::kSpool}) {
    commands->motors[static_cast<std::size_t>(motor)] = move_[static_cast<std::size_t>(motor)];
  }
  const bool over = sensed.tick >= until_ && WheelsThere(sensed);
  if (!over && sensed.tick < latest_) return false;
  begun_ = false;
  return ++current_ >= arcs_.size();
}

}  // namespace dockyard::axel
