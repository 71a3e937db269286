#include "models/read/read_imu.h"

#include <limits>

namespace dockyard {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// A unit reads at most as often as the longest physics step of any system, 5 ms, and at least once
// in the shortest control period, 20 ms.
constexpr Range kRates_hz = Between(50.0, 200.0);

InertialAxes ReadGyro(const YamlReader& imu) {
  const YamlReader in(imu.Child("gyro"), imu.PathOf("gyro"),
                      {"scale_share", "misalignment_deg", "range_deg_s", "step_deg_s"});
  return {in.NumberOr("scale_share", 0.0, NonNegative(0.5)),
          in.DegreesOr("misalignment_deg", 0.0, NonNegative(10.0)),
          in.DegreesOr("range_deg_s", kNoLimit, Positive(1e5)),
          in.DegreesOr("step_deg_s", 0.0, NonNegative(100.0))};
}

InertialAxes ReadAccelerometer(const YamlReader& imu) {
  const YamlReader in(imu.Child("accelerometer"), imu.PathOf("accelerometer"),
                      {"scale_share", "misalignment_deg", "range_m_s2", "step_m_s2"});
  return {in.NumberOr("scale_share", 0.0, NonNegative(0.5)),
          in.DegreesOr("misalignment_deg", 0.0, NonNegative(10.0)),
          in.NumberOr("range_m_s2", kNoLimit, Positive(1e4)),
          in.NumberOr("step_m_s2", 0.0, NonNegative(10.0))};
}

AttitudeUnit ReadUnit(const YamlReader& imu) {
  const YamlReader in(imu.Child("filter"), imu.PathOf("filter"),
                      {"kind", "rate_hz", "kp_per_s", "ki_per_s2", "beta_per_s"});
  AttitudeUnit unit;
  const bool mahony = in.Choice("kind", {"mahony", "madgwick"}) == 0;
  unit.filter = mahony ? AttitudeFilter::kMahony : AttitudeFilter::kMadgwick;
  unit.period_s = 1.0 / in.Number("rate_hz", kRates_hz);
  unit.kp_per_s = in.NumberOr("kp_per_s", unit.kp_per_s, NonNegative(100.0));
  unit.ki_per_s2 = in.NumberOr("ki_per_s2", unit.ki_per_s2, NonNegative(100.0));
  unit.beta_per_s = in.NumberOr("beta_per_s", unit.beta_per_s, NonNegative(10.0));
  for (const char* key : {"kp_per_s", "ki_per_s2"}) {
    if (!mahony && in.Has(key)) in.Refuse(key, "beta_per_s, the gain of madgwick");
  }
  if (mahony && in.Has("beta_per_s")) {
    in.Refuse("beta_per_s", "kp_per_s and ki_per_s2, the gains of mahony");
  }
  if (imu.Has("gyro")) unit.gyro = ReadGyro(imu);
  if (imu.Has("accelerometer")) unit.accelerometer = ReadAccelerometer(imu);
  return unit;
}

}  // namespace

ImuModel ReadImu(const YamlReader& root) {
  const YamlReader in(
      root.Child("imu"), "imu",
      {"position_m", "attitude_noise_deg", "attitude_bias_deg", "gyro_walk_deg_per_sqrt_h",
       "gyro_bias_deg_per_h", "gyro_instability_deg_per_h", "accel_walk_m_s_per_sqrt_h",
       "accel_bias_m_s2", "accel_instability_m_s2", "instability_time_s", "filter", "gyro",
       "accelerometer"});
  ImuModel imu;
  imu.p_RI = in.Vector3("position_m", Between(-5.0, 5.0));
  if (in.Has("filter")) {
    imu.unit = ReadUnit(in);
    for (const char* key : {"attitude_noise_deg", "attitude_bias_deg"}) {
      if (in.DegreesOr(key, 0.0, NonNegative(10.0)) == 0.0) continue;
      in.Refuse(key, "0 with a filter, whose attitude errs as its gyros and accelerometers do");
    }
  } else {
    imu.attitude_noise_rad = in.Degrees("attitude_noise_deg", NonNegative(10.0));
    imu.attitude_bias_rad = in.Degrees("attitude_bias_deg", NonNegative(10.0));
    for (const char* key : {"gyro", "accelerometer"}) {
      if (in.Has(key)) in.Refuse(key, "a filter as well, which goes by these readings");
    }
  }
  imu.gyro_walk_rad_sqrt_s = in.Degrees("gyro_walk_deg_per_sqrt_h", NonNegative(600.0)) / 60.0;
  imu.gyro_bias_rad_s = in.Degrees("gyro_bias_deg_per_h", NonNegative(36000.0)) / 3600.0;
  imu.gyro_instability_rad_s =
      in.Degrees("gyro_instability_deg_per_h", NonNegative(36000.0)) / 3600.0;
  imu.accel_walk_m_s_sqrt_s = in.Number("accel_walk_m_s_per_sqrt_h", NonNegative(600.0)) / 60.0;
  imu.accel_bias_m_s2 = in.Number("accel_bias_m_s2", NonNegative(10.0));
  imu.accel_instability_m_s2 = in.Number("accel_instability_m_s2", NonNegative(10.0));
  imu.instability_time_s = in.Number("instability_time_s", Between(1.0, 1e5));
  return imu;
}

}  // namespace dockyard
