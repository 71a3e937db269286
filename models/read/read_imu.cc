#include "models/read/read_imu.h"

namespace dockyard {

ImuModel ReadImu(const YamlReader& root) {
  const YamlReader in(
      root.Child("imu"), "imu",
      {"position_m", "attitude_noise_deg", "attitude_bias_deg", "gyro_walk_deg_per_sqrt_h",
       "gyro_bias_deg_per_h", "gyro_instability_deg_per_h", "accel_walk_m_s_per_sqrt_h",
       "accel_bias_m_s2", "accel_instability_m_s2", "instability_time_s"});
  ImuModel imu;
  imu.p_RI = in.Vector3("position_m", Between(-5.0, 5.0));
  imu.attitude_noise_rad = in.Degrees("attitude_noise_deg", NonNegative(10.0));
  imu.attitude_bias_rad = in.Degrees("attitude_bias_deg", NonNegative(10.0));
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
