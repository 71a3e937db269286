#include "models/axel/load_axel.h"

#include <algorithm>
#include <cmath>

#include "models/axel/rover_links.h"
#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "models/read/load_wheel.h"
#include "models/read/text_file.h"
#include "models/read/urdf.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {
namespace {

MotorModel ReadMotor(const YamlReader& motors, const char* name) {
  const YamlReader in(
      motors.Child(name), motors.PathOf(name),
      {"torque_per_amp_nm", "no_load_current_a", "max_current_a", "gear_friction_nm",
       "brake_torque_nm", "max_speed_rad_s", "max_accel_rad_s2", "reflected_inertia_kg_m2",
       "counts_per_rev", "current_noise_a", "gear_efficiency", "profile"});
  MotorModel motor;
  motor.torque_per_amp_nm = in.Number("torque_per_amp_nm", Positive(1e4));
  motor.no_load_current_a = in.Number("no_load_current_a", NonNegative(100.0));
  motor.max_current_a = in.Number("max_current_a", Positive(1000.0));
  motor.gear_friction_nm = in.Number("gear_friction_nm", NonNegative(1e3));
  motor.brake_torque_nm = in.Number("brake_torque_nm", NonNegative(1e5));
  motor.max_speed_rad_s = in.Number("max_speed_rad_s", Positive(100.0));
  motor.max_accel_rad_s2 = in.Number("max_accel_rad_s2", Positive(1000.0));
  motor.reflected_inertia_kg_m2 = in.Number("reflected_inertia_kg_m2", Positive(1e4));
  motor.counts_per_rev = in.Integer("counts_per_rev", 16, 1 << 30);
  motor.current_noise_a = in.Number("current_noise_a", NonNegative(10.0));
  motor.gear_efficiency = in.NumberOr("gear_efficiency", 1.0, Between(0.2, 1.0));
  motor.profile = in.ChoiceOr("profile", 0, {"trapezoid", "spline"}) == 0 ? ProfileShape::kTrapezoid
                                                                          : ProfileShape::kSpline;
  if (motor.max_current_a <= motor.no_load_current_a) {
    in.Refuse("max_current_a", "more than no_load_current_a");
  }
  return motor;
}

void ReadMotors(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(root.Child("motors"), "motors", {"wheel", "arm", "spool"});
  const MotorModel wheel = ReadMotor(in, "wheel");
  rover.motors[static_cast<int>(Motor::kLeftWheel)] = wheel;
  rover.motors[static_cast<int>(Motor::kRightWheel)] = wheel;
  rover.motors[static_cast<int>(Motor::kArm)] = ReadMotor(in, "arm");
  rover.motors[static_cast<int>(Motor::kSpool)] = ReadMotor(in, "spool");
}

void ReadWheels(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(root.Child("wheels"), "wheels",
                      {"radius_m", "width_m", "paddles", "left_phase_deg", "right_phase_deg"});
  const WheelModel wheel = ReadWheelShape(in);
  rover.left_wheel_soil = rover.right_wheel_soil = wheel;
  rover.left_wheel_soil.phase_rad = in.DegreesOr("left_phase_deg", 0.0, Between(-180.0, 180.0));
  rover.right_wheel_soil.phase_rad = in.DegreesOr("right_phase_deg", 0.0, Between(-180.0, 180.0));
}

void ReadCollar(const YamlReader& arm, RoverModel& rover) {
  if (!arm.Has("collar")) return;
  const YamlReader in(arm.Child("collar"), arm.PathOf("collar"),
                      {"radius_m", "front_m", "front_radius_m", "lead_in_m", "length_m"});
  CollarModel& collar = rover.collar;
  collar.radius_m = in.Number("radius_m", Positive(0.5));
  collar.front_m = in.Number("front_m", Positive(5.0));
  collar.front_radius_m = in.Number("front_radius_m", Between(0.002, 0.5));
  collar.lead_in_m = in.Number("lead_in_m", Between(0.002, 1.0));
  collar.length_m = in.Number("length_m", Between(0.002, 1.0));
  if (collar.front_m > rover.arm_length_m - rover.tip.length_m) {
    in.Refuse("front_m", "at most length_m - tip_length_m: a collar behind the tip");
  }
  if (collar.lead_in_m + collar.length_m >= collar.front_m) {
    in.Refuse("length_m", "a collar that ends before the axle");
  }
  if (collar.front_radius_m > collar.radius_m) {
    in.Refuse("front_radius_m", "at most radius_m: the lead-in widens backwards");
  }
}

void ReadArm(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(root.Child("arm"), "arm",
                      {"length_m", "at_power_on_deg", "tip_radius_m", "tip_length_m",
                       "ground_friction", "ground_stiffness_n_per_m", "collar"});
  rover.arm_length_m = in.Number("length_m", Positive(5.0));
  rover.arm_at_power_on_rad = in.Degrees("at_power_on_deg", Between(-180.0, 180.0));
  rover.tip.radius_m = in.Number("tip_radius_m", Positive(0.5));
  rover.tip.length_m = in.Number("tip_length_m", Positive(1.0));
  rover.tip.ground_friction = in.Number("ground_friction", NonNegative(2.0));
  rover.tip.ground_stiffness_n_per_m = in.Number("ground_stiffness_n_per_m", Between(100.0, 1e6));
  if (rover.tip.length_m >= rover.arm_length_m) in.Refuse("tip_length_m", "less than length_m");
  ReadCollar(in, rover);
}

void ReadTether(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(root.Child("tether"), "tether",
                      {"axial_stiffness_n", "damping_ns_per_m", "diameter_m", "mass_kg_per_m",
                       "friction_on_station", "drum_radius_m"});
  TetherModel& tether = rover.tether;
  tether.axial_stiffness_n = in.Number("axial_stiffness_n", Between(100.0, 1e6));
  tether.damping_ns_per_m = in.Number("damping_ns_per_m", NonNegative(1e5));
  tether.diameter_m = in.Number("diameter_m", Positive(0.05));
  tether.mass_kg_per_m = in.Number("mass_kg_per_m", NonNegative(5.0));
  tether.friction_on_station = in.Number("friction_on_station", NonNegative(2.0));
  tether.drum_radius_m = in.Number("drum_radius_m", Between(0.005, 0.5));
}

void ReadImu(const YamlReader& root, RoverModel& rover) {
  const YamlReader in(
      root.Child("imu"), "imu",
      {"position_m", "attitude_noise_deg", "attitude_bias_deg", "gyro_walk_deg_per_sqrt_h",
       "gyro_bias_deg_per_h", "gyro_instability_deg_per_h", "accel_walk_m_s_per_sqrt_h",
       "accel_bias_m_s2", "accel_instability_m_s2", "instability_time_s"});
  ImuModel& imu = rover.imu;
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
}

/// Cameras side by side, facing along the body's x axis, pitched down together.
StereoRig MakeRig(double baseline_m, double forward_m, double height_m, double pitch_rad,
                  const Camera& camera) {
  Eigen::Matrix3d R_level;  // z along the view, x right, y down
  R_level.col(0) = -Eigen::Vector3d::UnitY();
  R_level.col(1) = -Eigen::Vector3d::UnitZ();
  R_level.col(2) = Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d R = RotY(pitch_rad) * R_level;
  StereoRig rig;
  rig.left = rig.right = camera;
  rig.X_RL = {R, Eigen::Vector3d(forward_m, 0.5 * baseline_m, height_m)};
  rig.X_RQ = {R, Eigen::Vector3d(forward_m, -0.5 * baseline_m, height_m)};
  return rig;
}

StereoRig ReadRig(const YamlReader& in, int width, int height) {
  if (in.Has("file")) {
    for (const char* key :
         {"baseline_m", "forward_m", "height_m", "pitch_deg", "field_of_view_deg"}) {
      if (in.Has(key)) in.Refuse(key, "no such key beside cameras.file, which sets it");
    }
    return LoadRig(in.File("file"), width, height);
  }
  const double fov_rad = in.Degrees("field_of_view_deg", Between(10.0, 200.0));
  return MakeRig(in.Number("baseline_m", Between(0.01, 2.0)),
                 in.Number("forward_m", Between(-2.0, 2.0)),
                 in.Number("height_m", Between(-2.0, 3.0)),
                 in.DegreesOr("pitch_deg", 0.0, Between(-60.0, 60.0)),
                 EquidistantCamera(width > 0 ? width : kDefaultImageWidth,
                                   height > 0 ? height : kDefaultImageHeight, fov_rad));
}

ExposureModel ReadExposure(const YamlReader& sensor) {
  ExposureModel exposure;
  if (!sensor.Has("exposure")) return exposure;
  const YamlReader in(sensor.Child("exposure"), sensor.PathOf("exposure"),
                      {"rule", "percent", "level", "fixed_e", "bracket_stops"});
  exposure.rule =
      static_cast<ExposureRule>(in.ChoiceOr("rule", 0, {"automatic", "fixed", "bracketed"}));
  exposure.percent = in.NumberOr("percent", exposure.percent, Between(0.01, 99.0));
  exposure.level = in.NumberOr("level", exposure.level, Between(0.01, 1.0));
  exposure.bracket_stops = in.NumberOr("bracket_stops", exposure.bracket_stops, Positive(8.0));
  if (exposure.rule == ExposureRule::kFixed) exposure.fixed_e = in.Number("fixed_e", Positive(1e9));
  return exposure;
}

FocusModel ReadFocus(const YamlReader& sensor) {
  FocusModel focus;
  if (!sensor.Has("focus")) return focus;
  const YamlReader in(sensor.Child("focus"), sensor.PathOf("focus"),
                      {"focal_length_m", "f_number", "distance_m", "pixel_pitch_m"});
  focus.focal_length_m = in.Number("focal_length_m", Between(1e-4, 1.0));
  focus.f_number = in.Number("f_number", Between(0.5, 64.0));
  focus.distance_m = in.Number("distance_m", Positive(1e6));
  focus.pixel_pitch_m = in.Number("pixel_pitch_m", Between(1e-7, 1e-3));
  if (focus.distance_m <= focus.focal_length_m) {
    in.Refuse("distance_m", "a number above focal_length_m");
  }
  return focus;
}

void ReadCameras(const YamlReader& root, int width, int height, RoverModel& rover) {
  const YamlReader in(root.Child("cameras"), "cameras",
                      {"file", "baseline_m", "forward_m", "height_m", "pitch_deg",
                       "field_of_view_deg", "as_built", "sensor"});
  StereoModel& stereo = rover.stereo;
  stereo.nominal = ReadRig(in, width, height);
  const YamlReader built(
      in.Child("as_built"), in.PathOf("as_built"),
      {"relative_yaw_deg", "rotation_deg", "focal_relative", "centre_px", "radial_px"});
  stereo.relative_yaw_sigma_rad = built.Degrees("relative_yaw_deg", NonNegative(5.0));
  stereo.rotation_sigma_rad = built.Degrees("rotation_deg", NonNegative(5.0));
  stereo.focal_sigma = built.Number("focal_relative", NonNegative(0.1));
  stereo.centre_sigma_px = built.Number("centre_px", NonNegative(50.0));
  stereo.radial_sigma_px = built.Number("radial_px", NonNegative(50.0));
  const YamlReader sensor(in.Child("sensor"), in.PathOf("sensor"),
                          {"full_well_e", "read_noise_e", "vignetting_exponent", "blur_sigma_px",
                           "response_sigma", "bits", "exposure", "focus"});
  stereo.full_well_e = sensor.Number("full_well_e", Between(100.0, 1e6));
  stereo.read_noise_e = sensor.Number("read_noise_e", NonNegative(1e4));
  stereo.vignetting_exponent = sensor.Number("vignetting_exponent", NonNegative(8.0));
  stereo.blur_sigma_px = sensor.Number("blur_sigma_px", NonNegative(10.0));
  stereo.response_sigma = sensor.NumberOr("response_sigma", 0.0, NonNegative(0.2));
  stereo.bits = sensor.IntegerOr("bits", 8, 8, 16);
  stereo.exposure = ReadExposure(sensor);
  stereo.focus = ReadFocus(sensor);
}

/// The URDF holds some numbers for other tools that the YAML holds for the soil and the cone. They
/// must agree to 1 mm: a collision cylinder named "tip" and each wheel's largest collision
/// cylinder.
void CheckAgreement(const YamlReader& root, const RoverModel& rover) {
  constexpr double kSame_m = 1e-3;
  for (const Collision& part : rover.arm.collisions) {
    const auto* tip = std::get_if<CylinderShape>(&part.shape);
    if (part.name != "tip" || tip == nullptr) continue;
    const double front = part.X_LG.p.x() + 0.5 * tip->length_m;
    if (std::abs(tip->radius_m - rover.tip.radius_m) > kSame_m ||
        std::abs(front - rover.arm_length_m) > kSame_m) {
      root.Refuse("arm", "the radius and front of collision 'tip' of the URDF, " +
                             NumberText(tip->radius_m) + " and " + NumberText(front));
    }
  }
  const double tip_radius =
      rover.left_wheel_soil.rim_radius_m +
      (rover.left_wheel_soil.paddle_count > 0 ? rover.left_wheel_soil.paddle_height_m : 0.0);
  for (const LinkModel* wheel : {&rover.left_wheel, &rover.right_wheel}) {
    double largest = 0.0;  // smaller ones are hubs and caps
    for (const Collision& part : wheel->collisions) {
      const auto* disc = std::get_if<CylinderShape>(&part.shape);
      if (disc != nullptr) largest = std::max(largest, disc->radius_m);
    }
    if (largest == 0.0 || std::abs(largest - tip_radius) <= kSame_m) continue;
    root.Refuse("wheels",
                "rim and paddle to add up to the radius of the wheel's collision "
                "cylinder in the URDF, " +
                    NumberText(largest),
                NumberText(std::round(1e6 * tip_radius) / 1e6));
  }
  if (rover.arm_at_power_on_rad < rover.arm_lower_rad ||
      rover.arm_at_power_on_rad > rover.arm_upper_rad) {
    root.Refuse("arm", "at_power_on_deg within the limits of the URDF's arm_joint");
  }
}

}  // namespace

RoverModel LoadRover(const std::string& file, int image_width, int image_height,
                     const YamlNode* changes, MeshStore* meshes) {
  YamlNode tree = LoadYaml(file);
  if (changes != nullptr) MergeYaml(tree, *changes);
  const YamlReader in(tree, "",
                      {"name", "urdf", "mass_scale", "body_com_x_m", "wheels", "motors", "arm",
                       "tether", "imu", "cameras"});
  RoverModel rover;
  rover.name = in.Text("name");
  ReadWheels(in, rover);
  ReadMotors(in, rover);
  ReadArm(in, rover);
  ReadTether(in, rover);
  ReadImu(in, rover);
  ReadCameras(in, image_width, image_height, rover);
  TakeRoverLinks(LoadUrdf(in.File("urdf"), meshes), rover);
  const double scale = in.NumberOr("mass_scale", 1.0, Between(0.1, 10.0));
  for (LinkModel* link : {&rover.body, &rover.left_wheel, &rover.right_wheel, &rover.arm}) {
    link->mass_kg *= scale;
    link->I_LCom_L *= scale;
  }
  double& com_x_m = rover.body.p_LoCom_L.x();
  com_x_m = in.NumberOr("body_com_x_m", com_x_m, Between(-1.0, 1.0));
  CheckAgreement(in, rover);
  return rover;
}

}  // namespace dockyard::axel
