#include "controller/rocky7/arc_drive.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/steering.h"

namespace dockyard::rocky7 {
namespace {

// A drive has arrived within this of its target. Assumed, 0.05-0.5 deg.
constexpr double kArrived_rad = Radians(0.2);
// A drive that load holds back is left after so much more than its move takes. Assumed, 1-5 s.
constexpr double kPatience_s = 2.0;
// After the last turn of the wheels the suspension comes to rest. Assumed, 0.2-1 s.
constexpr Tick kRest = 400;

// Of a trapezoid with ramps.
double TimeOf(double way_rad, double speed_rad_s, double accel_rad_s2) {
  return way_rad / speed_rad_s + speed_rad_s / accel_rad_s2;
}

}  // namespace

ArcDrive::ArcDrive(const Nominal& nominal) : nominal_(nominal) {
  commands_.resize(nominal_.motors.size());
}

void ArcDrive::Start(const Arc& arc) {
  arc_ = arc;
  moved_ = {};
  driven_m_ = share_ = 0.0;
  start_rad_.clear();
  phase_ = Phase::kSteer;
}

void ArcDrive::BeginSteering(const SensorFrame& sensed) {
  start_rad_.resize(nominal_.motors.size());
  for (std::size_t i = 0; i < start_rad_.size(); ++i) start_rad_[i] = AngleOf(nominal_, sensed, i);
  since_ = sensed.tick;
  commands_.assign(nominal_.motors.size(), {});
  std::size_t motor = wheels();
  for (const WheelPlan& wheel : nominal_.plan.wheels) {
    if (wheel.steer_limit_rad == 0.0) continue;
    const NominalMotor& drive = nominal_.motors[motor];
    commands_[motor] = MoveTo(drive, OnArc(wheel, arc_).steer_rad, drive.max_speed_rad_s);
    ++motor;
  }
}

void ArcDrive::BeginDriving(const SensorFrame& sensed) {
  since_ = sensed.tick;
  double most_rad = 0.0;
  for (const WheelPlan& wheel : nominal_.plan.wheels) {
    most_rad = std::max(most_rad, std::abs(OnArc(wheel, arc_).way_m) / nominal_.rolling_radius_m);
  }
  const double speed_rad_s = nominal_.plan.speed_m_s / nominal_.rolling_radius_m;
  for (std::size_t i = 0; i < wheels(); ++i) {
    const double way_rad = OnArc(nominal_.plan.wheels[i], arc_).way_m / nominal_.rolling_radius_m;
    // All wheels begin and end together.
    const double share = std::max(1e-3, std::abs(way_rad) / std::max(most_rad, 1e-9));
    commands_[i] = MoveTo(nominal_.motors[i], start_rad_[i] + way_rad, share * speed_rad_s, share);
  }
}

bool ArcDrive::Arrived(const SensorFrame& sensed, std::size_t first, std::size_t count) const {
  double longest_s = 0.0;
  bool all = true;
  for (std::size_t i = first; i < first + count; ++i) {
    const MotorCommand& command = commands_[i];
    if (command.mode != MotorMode::kPosition) continue;
    all = all && std::abs(AngleOf(nominal_, sensed, i) - command.target) < kArrived_rad;
    longest_s = std::max(longest_s, TimeOf(std::abs(command.target - start_rad_[i]),
                                           command.speed_limit_rad_s, command.accel_rad_s2));
  }
  const double since_s = static_cast<double>(sensed.tick - since_) * kTickSeconds;
  return all || since_s > longest_s + kPatience_s;
}

// The share of their ways that the fixed wheels have turned.
void ArcDrive::Count(const SensorFrame& sensed) {
  double turned_m = 0.0, whole_m = 0.0;
  for (std::size_t i = 0; i < wheels(); ++i) {
    const WheelPlan& wheel = nominal_.plan.wheels[i];
    if (wheel.steer_limit_rad > 0.0) continue;
    const double way_m = OnArc(wheel, arc_).way_m;
    const double rolled_m =
        (AngleOf(nominal_, sensed, i) - start_rad_[i]) * nominal_.rolling_radius_m;
    turned_m += way_m < 0.0 ? -rolled_m : rolled_m;
    whole_m += std::abs(way_m);
  }
  if (whole_m == 0.0) return;
  share_ = std::clamp(turned_m / whole_m, 0.0, 1.0);
  const Arc part = Part(arc_, share_);
  moved_ = Advance({}, part);
  driven_m_ = part.length_m;
}

void ArcDrive::Stop(const SensorFrame& sensed) {
  phase_ = Phase::kRest;
  since_ = sensed.tick;
  commands_.assign(commands_.size(), {});
}

std::vector<MotorCommand> ArcDrive::Step(const SensorFrame& sensed) {
  if (phase_ == Phase::kSteer && start_rad_.empty()) BeginSteering(sensed);
  if (phase_ == Phase::kSteer && Arrived(sensed, wheels(), commands_.size() - wheels())) {
    phase_ = Phase::kDrive;
    BeginDriving(sensed);
  }
  if (phase_ == Phase::kDrive) Count(sensed);
  if (phase_ == Phase::kDrive && Arrived(sensed, 0, wheels())) {
    Stop(sensed);  // the steering holds its angle for the next arc
  }
  if (phase_ == Phase::kRest) {
    Count(sensed);
    if (sensed.tick - since_ >= kRest) phase_ = Phase::kDone;
  }
  return commands_;
}

}  // namespace dockyard::rocky7
