#include "models/read/read_imu.h"

#include <utility>

namespace dockyard {
namespace {

// A unit reads at most as often as the longest physics step of any system, 5 ms, and at least once
// in the shortest control period, 20 ms.
constexpr Range kRates_hz = Between(50.0, 200.0);

void VisitAxes(Keys& keys, InertialAxes& axes) {
  keys.Number(Optional("scale_share"), axes.scale_share, NonNegative(0.5));
  keys.Degrees(Optional("misalignment_deg"), axes.misalignment_rad, NonNegative(10.0));
}

void VisitGyro(Keys& keys, InertialAxes& axes) {
  VisitAxes(keys, axes);
  keys.Degrees(Unset("range_deg_s"), axes.range, Positive(1e5));
  keys.Degrees(Optional("step_deg_s"), axes.step, NonNegative(100.0));
}

void VisitAccelerometer(Keys& keys, InertialAxes& axes) {
  VisitAxes(keys, axes);
  keys.Number(Unset("range_m_s2"), axes.range, Positive(1e4));
  keys.Number(Optional("step_m_s2"), axes.step, NonNegative(10.0));
}

void VisitFilter(Keys& keys, AttitudeUnit& unit) {
  keys.Choice("kind", unit.filter, {"mahony", "madgwick"});
  double rate_hz = 1.0 / unit.period_s;
  keys.Number("rate_hz", rate_hz, kRates_hz);
  unit.period_s = 1.0 / rate_hz;
  keys.Number(Optional("kp_per_s"), unit.kp_per_s, NonNegative(100.0));
  keys.Number(Optional("ki_per_s2"), unit.ki_per_s2, NonNegative(100.0));
  keys.Number(Optional("beta_per_s"), unit.beta_per_s, NonNegative(10.0));
  const bool mahony = unit.filter == AttitudeFilter::kMahony;
  for (const char* key : {"kp_per_s", "ki_per_s2"}) {
    keys.Allow(key, mahony, "beta_per_s, the gain of madgwick");
  }
  keys.Allow("beta_per_s", !mahony, "kp_per_s and ki_per_s2, the gains of mahony");
}

/// What a filter goes by.
void VisitUnit(Keys& keys, std::optional<AttitudeUnit>& unit) {
  keys.Mapping(Unset("filter"), [&](Keys& in) { VisitFilter(in, unit ? *unit : unit.emplace()); });
  AttitudeUnit none;
  AttitudeUnit& known = unit ? *unit : none;
  for (const char* key : {"gyro", "accelerometer"}) {
    keys.Allow(key, unit.has_value(), "a filter as well, which goes by these readings");
  }
  keys.Mapping(Unset("gyro"), [&](Keys& in) { VisitGyro(in, known.gyro); });
  keys.Mapping(Unset("accelerometer"),
               [&](Keys& in) { VisitAccelerometer(in, known.accelerometer); });
}

}  // namespace

void VisitImu(Keys& keys, ImuModel& imu) {
  keys.Vector3("position_m", imu.p_RI, Between(-5.0, 5.0));
  VisitUnit(keys, imu.unit);
  for (const auto& [key, error_rad] : {std::pair("attitude_noise_deg", &imu.attitude_noise_rad),
                                       std::pair("attitude_bias_deg", &imu.attitude_bias_rad)}) {
    keys.Degrees(keys.NeededIf(!imu.unit, key), *error_rad, NonNegative(10.0));
    keys.Check(key, !imu.unit || *error_rad == 0.0,
               "0 with a filter, whose attitude errs as its gyros and accelerometers do");
  }
  // In the file walks are a root of an hour, rates an hour.
  const auto per = [](double parts, double& value, const auto& visit) {
    double whole = parts * value;
    visit(whole);
    value = whole / parts;
  };
  const auto degrees = [&](const char* key, double parts, double& value, double most_deg) {
    per(parts, value, [&](double& whole) { keys.Degrees(key, whole, NonNegative(most_deg)); });
  };
  degrees("gyro_walk_deg_per_sqrt_h", 60.0, imu.gyro_walk_rad_sqrt_s, 600.0);
  degrees("gyro_bias_deg_per_h", 3600.0, imu.gyro_bias_rad_s, 36000.0);
  degrees("gyro_instability_deg_per_h", 3600.0, imu.gyro_instability_rad_s, 36000.0);
  per(60.0, imu.accel_walk_m_s_sqrt_s,
      [&](double& whole) { keys.Number("accel_walk_m_s_per_sqrt_h", whole, NonNegative(600.0)); });
  keys.Number("accel_bias_m_s2", imu.accel_bias_m_s2, NonNegative(10.0));
  keys.Number("accel_instability_m_s2", imu.accel_instability_m_s2, NonNegative(10.0));
  keys.Number("instability_time_s", imu.instability_time_s, Between(1.0, 1e5));
}

}  // namespace dockyard
