#include "models/read/read_imu.h"

#include <utility>

namespace dockyard {
namespace {

// A unit reads at most as often as the longest physics step of any system, 5 ms, and at least once
// in the shortest control period, 20 ms.
constexpr Range kRates_hz = Between(50.0, 200.0);

void VisitAxes(Keys& keys, InertialAxes& axes) {
  keys.Number({"scale_share", "", "error of an axis' scale, 1 sigma"}, axes.scale_share,
              NonNegative(0.5));
  keys.Degrees({"misalignment_deg", "deg", "of an axis towards each other one, 1 sigma"},
               axes.misalignment_rad, NonNegative(10.0));
}

void VisitGyro(Keys& keys, InertialAxes& axes) {
  VisitAxes(keys, axes);
  keys.Degrees({"range_deg_s", "deg/s", "beyond it a reading is cut off", Presence::kUnset},
               axes.range, Positive(1e5));
  keys.Degrees({"step_deg_s", "deg/s", "of a reading; 0: none"}, axes.step, NonNegative(100.0));
}

void VisitAccelerometer(Keys& keys, InertialAxes& axes) {
  VisitAxes(keys, axes);
  keys.Number({"range_m_s2", "m/s^2", "beyond it a reading is cut off", Presence::kUnset},
              axes.range, Positive(1e4));
  keys.Number({"step_m_s2", "m/s^2", "of a reading; 0: none"}, axes.step, NonNegative(10.0));
}

void VisitFilter(Keys& keys, AttitudeUnit& unit) {
  keys.Choice({"kind", "", "of the attitude filter", Presence::kRequired}, unit.filter,
              {"mahony", "madgwick"});
  double rate_hz = 1.0 / unit.period_s;
  keys.Number({"rate_hz", "Hz", "of its readings", Presence::kRequired}, rate_hz, kRates_hz);
  unit.period_s = 1.0 / rate_hz;
  keys.Number({"kp_per_s", "1/s", "gain of mahony"}, unit.kp_per_s, NonNegative(100.0));
  keys.Number({"ki_per_s2", "1/s^2", "gain of mahony on the gyros' bias"}, unit.ki_per_s2,
              NonNegative(100.0));
  keys.Number({"beta_per_s", "1/s", "gain of madgwick"}, unit.beta_per_s, NonNegative(10.0));
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
  keys.Vector3({"position_m", "m", "of the unit on the body", Presence::kRequired}, imu.p_RI,
               Between(-5.0, 5.0));
  VisitUnit(keys, imu.unit);
  const Presence needed = keys.reads() && !imu.unit ? Presence::kRequired : Presence::kUnset;
  keys.Degrees({"attitude_noise_deg", "deg", "of roll and pitch, 1 sigma of a reading", needed},
               imu.attitude_noise_rad, NonNegative(10.0));
  keys.Degrees({"attitude_bias_deg", "deg", "the same from power-on to power-on", needed},
               imu.attitude_bias_rad, NonNegative(10.0));
  for (const auto& [key, error_rad] : {std::pair("attitude_noise_deg", &imu.attitude_noise_rad),
                                       std::pair("attitude_bias_deg", &imu.attitude_bias_rad)}) {
    keys.Check(key, !imu.unit || *error_rad == 0.0,
               "0 with a filter, whose attitude errs as its gyros and accelerometers do");
  }
  // In the file walks are a root of an hour, rates an hour.
  const auto per = [](double parts, double& value, const auto& visit) {
    double whole = parts * value;
    visit(whole);
    value = whole / parts;
  };
  const auto needs = [](const char* name, const char* unit, const char* meaning) {
    return Key(name, unit, meaning, Presence::kRequired);
  };
  const auto degrees = [&](const Key& key, double parts, double& value, double most_deg) {
    per(parts, value, [&](double& whole) { keys.Degrees(key, whole, NonNegative(most_deg)); });
  };
  degrees(needs("gyro_walk_deg_per_sqrt_h", "deg/sqrt(h)", "angle random walk"), 60.0,
          imu.gyro_walk_rad_sqrt_s, 600.0);
  degrees(needs("gyro_bias_deg_per_h", "deg/h", "from power-on to power-on, 1 sigma"), 3600.0,
          imu.gyro_bias_rad_s, 36000.0);
  degrees(needs("gyro_instability_deg_per_h", "deg/h", "of the bias' wandering, 1 sigma"), 3600.0,
          imu.gyro_instability_rad_s, 36000.0);
  per(60.0, imu.accel_walk_m_s_sqrt_s, [&](double& whole) {
    keys.Number(needs("accel_walk_m_s_per_sqrt_h", "m/s/sqrt(h)", "velocity random walk"), whole,
                NonNegative(600.0));
  });
  keys.Number(needs("accel_bias_m_s2", "m/s^2", "from power-on to power-on, 1 sigma"),
              imu.accel_bias_m_s2, NonNegative(10.0));
  keys.Number(needs("accel_instability_m_s2", "m/s^2", "of the bias' wandering, 1 sigma"),
              imu.accel_instability_m_s2, NonNegative(10.0));
  keys.Number(needs("instability_time_s", "s", "correlation time of the wandering"),
              imu.instability_time_s, Between(1.0, 1e5));
  keys.Number({"clock_offset_s", "s", "by which a frame's readings are old at power-on"},
              imu.clock_offset_s, NonNegative(0.5));
  keys.Number({"clock_drift_ppm", "ppm", "by which they grow older, of the time since"},
              imu.clock_drift_ppm, Between(-1000.0, 1000.0));
}

}  // namespace dockyard
