#include "sim/axel/shake.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/axle_attitude.h"

namespace dockyard::axel {
namespace {

// How a claim is tried: docs/reference/outcomes.md. Assumed, ranges 0.05-0.2 rad/s and m/s, 5-20
// deg, 0.1-0.3 m.
constexpr double kYawRate = 0.1;    // [rad/s]
constexpr Tick kYawTicks = 1920;    // 0.1 rad/s for 1.92 s: 11 deg
constexpr double kAwaySpeed = 0.1;  // [m/s]
constexpr Tick kAwayTicks = 2000;

class Shaker {
 public:
  Shaker(World& world, const RoverModel& rover, const StationModel& station,
         const std::function<void(const Truth&)>& watch)
      : world_(world), rover_(rover), watch_(watch), p_SM_(MouthInStation(station).p) {
    const Truth before = world_.truth();
    heading_ = AxleOnGround(before.X_DR).heading;
    p_MT_ = before.p_MT;
    least_depth_ = -p_MT_.x();
    p_WM_ = before.X_WS * p_SM_;
    station_shift_m_ = before.station_shift_m;
  }

  void Drive(double forward_m_s, double turn_rad_s, Tick ticks) {
    const double radius = RollingRadius(rover_.left_wheel_soil);
    const double half_track = 0.5 * (rover_.p_R_left_wheel.y() - rover_.p_R_right_wheel.y());
    std::array<MotorCommand, kMotorCount> commands{};
    commands[0] = Wheel((forward_m_s - half_track * turn_rad_s) / radius, Motor::kLeftWheel);
    commands[1] = Wheel((forward_m_s + half_track * turn_rad_s) / radius, Motor::kRightWheel);
    const Tick start = world_.tick();
    Tick next = start;  // to be observed
    while (world_.tick() < start + ticks) {
      world_.Step(commands);
      if (world_.tick() <= next) continue;
      Observe();
      next += kControlPeriod;
    }
    Observe();
  }

  ShakeResult result() const { return {true, turn_, travel_, least_depth_, dragged_}; }

 private:
  MotorCommand Wheel(double speed_rad_s, Motor motor) const {
    const MotorModel& model = rover_.motors[static_cast<int>(motor)];
    return {.mode = MotorMode::kVelocity,
            .target = speed_rad_s,
            .accel_rad_s2 = model.max_accel_rad_s2,
            .current_limit_a = model.max_current_a};
  }

  void Observe() {
    Truth now = world_.truth();
    now.station_shift_m = station_shift_m_;
    now.station_shake_m = (now.X_WS * p_SM_ - p_WM_).norm();
    turn_ = std::max(turn_, std::abs(WrapPi(AxleOnGround(now.X_DR).heading - heading_)));
    travel_ = std::max(travel_, (now.p_MT - p_MT_).norm());
    least_depth_ = std::min(least_depth_, -now.p_MT.x());
    dragged_ = std::max(dragged_, now.station_shake_m);
    if (watch_) watch_(now);
  }

  World& world_;
  const RoverModel& rover_;
  const std::function<void(const Truth&)>& watch_;
  double heading_ = 0.0, station_shift_m_ = 0.0;  // before the shake
  Eigen::Vector3d p_SM_, p_MT_, p_WM_;
  double turn_ = 0.0, travel_ = 0.0, least_depth_ = 0.0, dragged_ = 0.0;
};

}  // namespace

ShakeResult Shake(World& world, const RoverModel& rover, const StationModel& station,
                  const std::function<void(const Truth&)>& watch) {
  Shaker shaker(world, rover, station, watch);
  shaker.Drive(0.0, kYawRate, kYawTicks);
  shaker.Drive(0.0, -kYawRate, 2 * kYawTicks);
  shaker.Drive(0.0, kYawRate, kYawTicks);
  shaker.Drive(-kAwaySpeed, 0.0, kAwayTicks);
  return shaker.result();
}

}  // namespace dockyard::axel
