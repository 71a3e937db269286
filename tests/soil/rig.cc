#include "soil/rig.h"

#include <algorithm>
#include <cmath>

namespace dockyard::soil_test {

RigResult RunRig(const RigSetup& setup) {
  const double radius = setup.wheel.rim_radius_m;
  const double reach = radius + setup.wheel.paddle_height_m;
  HeightGrid grid =
      LevelGrid(-3.0 * reach, setup.travel_m + 6.0 * reach,
                8.0 * reach + 1.0 * setup.travel_m * std::sin(setup.side_slip_rad), setup.cell_m);
  WheelSoil contact(setup.wheel, setup.soil);
  const double mass_kg = setup.load_n / 9.81;
  const double inertia_kg_m2 = 0.5 * 0.3 * mass_kg * radius * radius;
  WheelMotion motion;
  motion.X_GK.p = Eigen::Vector3d(0.0, 0.0, reach);
  const Eigen::Vector3d drive_G(setup.speed_m_s * std::cos(setup.side_slip_rad),
                                setup.speed_m_s * std::sin(setup.side_slip_rad), 0.0);
  double spin_rad_s = setup.rim_speed_m_s / radius, angle = 0.0, sink_speed = 0.0;
  const int steps = static_cast<int>(setup.travel_m / setup.speed_m_s / setup.step_s);
  const int settle = steps / 2;
  RigResult result;
  double height_sum = 0.0, height_square = 0.0, ahead_square = 0.0, centre_sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    motion.X_GK.R = RotY(angle);
    motion.v_GK_G = drive_G + Eigen::Vector3d(0.0, 0.0, sink_speed);
    motion.w_GK_G = Eigen::Vector3d(0.0, spin_rad_s, 0.0);
    const WheelLoad load = contact.Step(grid, motion, setup.step_s);
    sink_speed += (load.force_G.z() - setup.load_n) / mass_kg * setup.step_s;
    if (setup.free_spin) spin_rad_s += load.torque_G.y() / inertia_kg_m2 * setup.step_s;
    motion.X_GK.p += (drive_G + Eigen::Vector3d(0.0, 0.0, sink_speed)) * setup.step_s;
    angle += spin_rad_s * setup.step_s;
    if (i < settle) continue;
    result.ahead_n += load.force_G.x();
    result.left_n += load.force_G.y();
    result.up_n += load.force_G.z();
    result.torque_nm += load.torque_G.y();
    result.rim_speed_m_s += spin_rad_s * radius;
    centre_sum += reach - motion.X_GK.p.z();
    height_sum += motion.X_GK.p.z();
    height_square += motion.X_GK.p.z() * motion.X_GK.p.z();
    ahead_square += load.force_G.x() * load.force_G.x();
  }
  const double samples = steps - settle;
  for (double* mean :
       {&result.ahead_n, &result.left_n, &result.up_n, &result.torque_nm, &result.rim_speed_m_s}) {
    *mean /= samples;
  }
  result.sinkage_m = centre_sum / samples;
  const double height = height_sum / samples;
  result.height_rms_m = std::sqrt(std::max(0.0, height_square / samples - height * height));
  result.ahead_rms_n =
      std::sqrt(std::max(0.0, ahead_square / samples - result.ahead_n * result.ahead_n));
  return result;
}

SoilModel PavlovSand() {
  // Pavlov and Johnson (2019), "#90" sand: bevameter and hand-tuned values of the authors' data
  // set; elastic and damping values assumed.
  SoilModel soil;
  soil.name = "sand_90";
  soil.n = 1.46;
  soil.n_slip = 0.5;
  soil.k_phi = 8.0e6;
  soil.cohesion_pa = 1000.0;
  soil.friction_angle_rad = Radians(29.0);
  soil.shear_modulus_m = 0.021;
  soil.density_kg_m3 = 1330.0;
  soil.unloading_stiffness_pa_per_m = 3.0e7;
  soil.damping_pa_s_per_m = 2.0e4;
  return soil;
}

SoilModel WongDrySand() {
  // Dry sand of the Land Locomotion Laboratory (Wong 2008, table 2.3); K of loose sand.
  SoilModel soil = PavlovSand();
  soil.name = "dry_sand";
  soil.n = 1.10;
  soil.n_slip = 0.5;
  soil.k_c = 0.99e3;
  soil.k_phi = 1528.43e3;
  soil.cohesion_pa = 1040.0;
  soil.friction_angle_rad = Radians(28.0);
  soil.shear_modulus_m = 0.025;
  soil.density_kg_m3 = 1500.0;
  return soil;
}

SoilModel CompactGranite() {
  // Crushed granite of the KRex rover's yard, as in the data set of Pavlov and Johnson (2019).
  SoilModel soil;
  soil.name = "compact_granite";
  soil.n = 0.6;
  soil.n_slip = 0.5;
  soil.k_phi = 2.5e6;
  soil.cohesion_pa = 5000.0;
  soil.friction_angle_rad = Radians(38.0);
  soil.shear_modulus_m = 0.040;
  soil.density_kg_m3 = 1963.0;
  soil.unloading_stiffness_pa_per_m = 2.0e8;
  soil.damping_pa_s_per_m = 5.0e4;
  return soil;
}

WheelModel PavlovWheel(bool paddled) {
  // Radius, width and grouser height as published; the grousers' tips cover 0.1 of the
  // circumference. Their number (24) is assumed, range 16-32.
  WheelModel wheel;
  wheel.rim_radius_m = 0.058;
  wheel.width_m = 0.050;
  if (!paddled) return wheel;
  wheel.paddle_count = 24;
  wheel.paddle_height_m = 0.005;
  wheel.paddle_thickness_m = 0.1 * 2.0 * kPi * 0.063 / 24;
  return wheel;
}

WheelModel AxelWheel(int paddle_count) {
  // Assumed throughout: radius 0.25-0.35 m, width 0.12-0.20 m, paddles 2-4 cm high.
  WheelModel wheel;
  wheel.rim_radius_m = 0.30;
  wheel.width_m = 0.15;
  if (paddle_count == 0) return wheel;
  wheel.paddle_count = paddle_count;
  wheel.paddle_height_m = 0.03;
  wheel.paddle_thickness_m = 0.006;
  return wheel;
}

}  // namespace dockyard::soil_test
