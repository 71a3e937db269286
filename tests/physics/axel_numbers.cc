#include "physics/axel_numbers.h"

#include <cmath>

#include "models/load_soil.h"

namespace dockyard {
namespace {

// All numbers assumed (Tsai et al. give none but the cameras' baseline): a 40 kg rover whose arm
// overbalances its body by 10 Nm, 9.81 (4 kg 0.5 m - 24 kg 0.0408 m).
constexpr double kTrackM = 0.85;

LinkModel Link(const char* name, double mass_kg, const Eigen::Vector3d& com,
               const Eigen::Vector3d& moments) {
  LinkModel link;
  link.name = name;
  link.mass_kg = mass_kg;
  link.p_LoCom_L = com;
  link.I_LCom_L = moments.asDiagonal();
  return link;
}

MotorModel Motor4(double torque_per_amp, double max_current, double friction, double brake,
                  double inertia) {
  MotorModel motor;
  motor.torque_per_amp_nm = torque_per_amp;
  motor.no_load_current_a = 0.2;
  motor.max_current_a = max_current;
  motor.gear_friction_nm = friction;
  motor.brake_torque_nm = brake;
  motor.max_speed_rad_s = 1.0;
  motor.max_accel_rad_s2 = 2.0;
  motor.reflected_inertia_kg_m2 = inertia;
  motor.counts_per_rev = 40000;
  motor.current_noise_a = 0.02;
  return motor;
}

WheelModel PaddleWheel() {
  WheelModel wheel;
  wheel.rim_radius_m = 0.265;
  wheel.width_m = 0.15;
  wheel.paddle_count = 12;
  wheel.paddle_height_m = 0.035;
  wheel.paddle_thickness_m = 0.015;
  return wheel;
}

}  // namespace

RoverModel TestRover() {
  RoverModel rover;
  rover.name = "axel";
  rover.body = Link("body", 24.0, {-0.0408, 0.0, 0.0}, {1.6, 0.9, 2.0});
  rover.left_wheel = Link("left_wheel", 6.0, {0, 0, 0}, {0.22, 0.38, 0.22});
  rover.right_wheel = Link("right_wheel", 6.0, {0, 0, 0}, {0.22, 0.38, 0.22});
  rover.arm = Link("arm", 4.0, {0.5, 0.0, 0.0}, {0.002, 0.34, 0.34});
  Pose3 X_RG;
  X_RG.p = Eigen::Vector3d(0.0, 0.0, 0.02);
  rover.body.collisions.push_back({"hull", BoxShape{{0.36, 0.6, 0.28}}, X_RG});
  Pose3 X_AG;
  X_AG.R = RotY(0.5 * kPi);
  X_AG.p.x() = 0.55;
  rover.arm.collisions.push_back({"shaft", CylinderShape{0.025, 0.78}, X_AG});
  Pose3 X_KG;
  X_KG.R = RotX(0.5 * kPi);
  rover.left_wheel.collisions.push_back({"rim", CylinderShape{0.3, 0.15}, X_KG});
  rover.right_wheel.collisions.push_back({"rim", CylinderShape{0.3, 0.15}, X_KG});
  rover.p_R_left_wheel = Eigen::Vector3d(0.0, 0.5 * kTrackM, 0.0);
  rover.p_R_right_wheel = Eigen::Vector3d(0.0, -0.5 * kTrackM, 0.0);
  rover.arm_lower_rad = -kPi;
  rover.arm_upper_rad = kPi;
  rover.arm_length_m = 1.0;
  rover.left_wheel_soil = rover.right_wheel_soil = PaddleWheel();
  rover.motors = {Motor4(15.0, 2.87, 1.5, 40.0, 0.8), Motor4(15.0, 2.87, 1.5, 40.0, 0.8),
                  Motor4(20.0, 4.5, 2.0, 80.0, 0.5), Motor4(10.0, 2.0, 0.3, 20.0, 0.5)};
  rover.tether.axial_stiffness_n = 60e3;
  rover.tether.damping_ns_per_m = 200.0;
  rover.tether.diameter_m = 0.006;
  rover.tether.mass_kg_per_m = 0.05;
  rover.tether.friction_on_station = 0.2;
  rover.tether.drum_radius_m = 0.06;
  rover.tip = {0.03, 0.06, 0.4, 2e4};
  rover.imu.p_RI = Eigen::Vector3d(0.05, 0.0, 0.1);
  rover.imu.attitude_noise_rad = Radians(0.05);
  rover.imu.attitude_bias_rad = Radians(0.2);
  rover.imu.gyro_walk_rad_sqrt_s = Radians(0.15) / 60.0;
  rover.imu.gyro_bias_rad_s = Radians(10.0) / 3600.0;
  rover.imu.gyro_instability_rad_s = Radians(0.5) / 3600.0;
  rover.imu.accel_walk_m_s_sqrt_s = 0.06 / 60.0;
  rover.imu.accel_bias_m_s2 = 0.02;
  rover.imu.accel_instability_m_s2 = 4.9e-4;
  return rover;
}

StationModel TestStation() {
  StationModel station;
  station.name = "module";
  station.module = Link("module", 35.0, {-0.25, 0.0, 0.25}, {2.2, 2.2, 2.2});
  station.tip_angle_rad = Radians(5.0);
  station.mouth_height_m = 0.37;
  station.cone.mouth_radius_m = 0.12;
  station.cone.funnel_length_m = 0.12;
  station.cone.throat_radius_m = 0.0325;
  station.cone.socket_end_m = 0.32;
  station.cone.face_outer_radius_m = 0.25;
  station.cone.wedges = 24;
  station.cone.funnel_friction = 0.2;
  station.cone.face_friction = 0.4;
  station.cone.contact_stiffness_n_per_m = 2e5;
  station.cone.contact_damping_ns_per_m = 1e3;
  station.anchor_depth_m = 0.35;
  for (double x : {-0.5, 0.0}) {
    for (double y : {-0.25, 0.25}) station.feet.push_back({{x, y, 0.0}});
  }
  station.foot_friction = 0.4;
  station.foot_stiffness_n_per_m = 1e5;
  return station;
}

SoilModel LooseSand() { return LoadSoil(DOCKYARD_SOURCE_DIR "/models/soils/loose_sand.yaml"); }

SoilModel CompactSand() {
  return LoadSoil(DOCKYARD_SOURCE_DIR "/models/soils/compact_gravel.yaml");
}

WorldSetup TestSetup(const SoilModel& soil, const Pose2& X_DR) {
  WorldSetup setup;
  setup.rover = TestRover();
  setup.station = TestStation();
  setup.soil = soil;
  setup.ground = LevelGrid(-1.0, 8.0, 6.0, 0.02);
  setup.X_DR_start = X_DR;
  return setup;
}

MotorCommands AllBraked() { return {}; }

MotorCommand Velocity(double rad_s, double current_a) {
  return {MotorMode::kVelocity, rad_s, 0.0, 1.0, current_a};
}

MotorCommand Position(double rad, double rad_s, double current_a) {
  return {MotorMode::kPosition, rad, rad_s, 1.0, current_a};
}

MotorCommand FreeWheel() { return {MotorMode::kFree, 0.0, 0.0, 0.0, 0.0}; }

MotorCommands Drive(double rad_s, double tension_n) {
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = Velocity(rad_s, 2.8);
  At(commands, Motor::kArm) = Position(0.0, 0.3, 4.4);
  if (tension_n > 0.0) {
    At(commands, Motor::kSpool) = Velocity(0.8, 0.2 + tension_n * 0.06 / 10.0);
  }
  return commands;
}

MotorCommands Reel(double tension_limit_n) {
  MotorCommands commands = Drive(0.0, tension_limit_n);
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  return commands;
}

void Play(World& world, const MotorCommands& commands, double seconds, double step_s) {
  const long steps = std::lround(seconds / step_s);
  for (long i = 0; i < steps; ++i) world.Step(commands);
}

}  // namespace dockyard
