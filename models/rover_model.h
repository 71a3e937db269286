// The two-wheeled tethered rover as built: URDF for what URDF can say, YAML for the rest.
// A WorldModel never changes during a run.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/io/sensors.h"
#include "models/mesh.h"

namespace dockyard {

/// Collision geometry of a link, from its URDF <collision> elements.
struct BoxShape {
  Eigen::Vector3d size_m{0, 0, 0};
};
struct CylinderShape {
  double radius_m = 0.0, length_m = 0.0;  // along the shape frame's z
};
struct SphereShape {
  double radius_m = 0.0;
};
/// A convex solid turned about the shape frame's z axis: (z, radius) from the lowest z up.
struct TurnedShape {
  std::vector<Eigen::Vector2d> profile_m;
};
struct HullShape {
  std::vector<Eigen::Vector3d> points;  // convex hull of these, in the shape frame [m]
};
struct Collision {
  std::string name;
  std::variant<BoxShape, CylinderShape, SphereShape, HullShape, TurnedShape> shape;
  Pose3 X_LG;  // shape frame in the link frame
};

/// A rigid link as URDF describes it.
struct LinkModel {
  std::string name;
  double mass_kg = 0.0;
  Eigen::Vector3d p_LoCom_L = Eigen::Vector3d::Zero();  // centre of mass [m]
  Eigen::Matrix3d I_LCom_L = Eigen::Matrix3d::Zero();   // about the centre of mass [kg m^2]
  std::vector<Visual> visuals;
  std::vector<Collision> collisions;
};

/// A wheel as the soil feels it: a rim with straight radial paddles across its whole width.
struct WheelModel {
  double rim_radius_m = 0.0;
  double width_m = 0.0;
  int paddle_count = 0;          // 0: a smooth wheel
  double paddle_height_m = 0.0;  // beyond the rim
  double paddle_thickness_m = 0.0;
  double phase_rad = 0.0;  // first paddle from the wheel frame's x axis, about +y
};

/// How far paddles stand out of the rim [m]; 0 for a smooth wheel.
inline double PaddleReach(const WheelModel& wheel) {
  return wheel.paddle_count > 0 ? wheel.paddle_height_m : 0.0;
}
/// From the axle to the paddles' tips [m]: what a turn of the wheel rolls off on hard ground.
inline double RollingRadius(const WheelModel& wheel) {
  return wheel.rim_radius_m + PaddleReach(wheel);
}

/// How a drive goes to its target: a trapezoid of speed, or a smooth polynomial (spline).
enum class ProfileShape : std::uint8_t { kTrapezoid, kSpline };

/// A geared motor with its drive, all at the output shaft.
struct MotorModel {
  double torque_per_amp_nm = 0.0;  // while the motor drives; gear efficiency included
  double gear_efficiency = 1.0;    // of the loaded teeth; below 1 they resist being driven back
  ProfileShape profile = ProfileShape::kTrapezoid;
  double no_load_current_a = 0.0;  // what the motor draws turning its own gears
  double max_current_a = 0.0;      // drive limit
  double gear_friction_nm = 0.0;   // Coulomb friction at the output, present in every mode
  double brake_torque_nm = 0.0;    // what MotorMode::kBrake holds
  double max_speed_rad_s = 0.0;
  double max_accel_rad_s2 = 0.0;         // the drive caps profiles at these
  double reflected_inertia_kg_m2 = 0.0;  // rotor inertia times gear ratio squared
  int counts_per_rev = 0;                // encoder at the output shaft
  double current_noise_a = 0.0;          // 1 sigma of one reading
};

struct TetherModel {
  double axial_stiffness_n = 0.0;  // EA: tension per strain [N]
  double damping_ns_per_m = 0.0;   // of the whole exposed length
  double diameter_m = 0.0;
  double mass_kg_per_m = 0.0;
  double friction_on_station = 0.0;  // capstan friction on the cone's lip and throat
  double drum_radius_m = 0.0;
};

struct ArmTipModel {
  double radius_m = 0.0;         // of the flat-nosed tip cylinder
  double length_m = 0.0;         // of the thick tip part
  double ground_friction = 0.0;  // dragging over soil
  double ground_stiffness_n_per_m = 0.0;
};

/// A collar behind the tip. It enters the throat last and, with the tip, holds the seated arm
/// straight. Lengths are along the arm; a radius of 0: the arm has none.
struct CollarModel {
  double radius_m = 0.0;
  double front_m = 0.0;         // from the axle to where the lead-in begins, on the shaft
  double front_radius_m = 0.0;  // there
  double lead_in_m = 0.0;       // of the cone from there back to the collar
  double length_m = 0.0;        // of the collar behind its lead-in
};

/// An inertial unit that integrates its own attitude: roll and pitch are held by gravity, yaw by
/// nothing, so that it drifts by what the gyro about z errs. Angle and velocity random walk are the
/// white noise of rate and specific force: a reading over dt has sigma walk / sqrt(dt) (IEEE 952).
struct ImuModel {
  Eigen::Vector3d p_RI{0, 0, 0};        // its place on the body [m]
  double attitude_noise_rad = 0.0;      // roll and pitch, 1 sigma of one reading
  double attitude_bias_rad = 0.0;       // roll and pitch, 1 sigma from power-on to power-on
  double gyro_walk_rad_sqrt_s = 0.0;    // angle random walk
  double gyro_bias_rad_s = 0.0;         // 1 sigma from power-on to power-on
  double gyro_instability_rad_s = 0.0;  // 1 sigma of the bias' wandering
  double accel_walk_m_s_sqrt_s = 0.0;   // velocity random walk
  double accel_bias_m_s2 = 0.0;         // 1 sigma from power-on to power-on
  double accel_instability_m_s2 = 0.0;  // 1 sigma of the bias' wandering
  double instability_time_s = 100.0;    // the wandering's correlation time
};

/// How the pictures' exposure is set.
enum class ExposureRule { kAutomatic, kFixed, kBracketed };
struct ExposureModel {
  ExposureRule rule = ExposureRule::kAutomatic;
  double percent = 5.0;        // automatic: this share of the pixels exceeds ...
  double level = 0.49;         // ... this share of the full well
  double fixed_e = 0.0;        // fixed: electrons of radiance 1
  double bracket_stops = 2.0;  // bracketed: pictures in turn at 0, less, more
};

/// Thin lens; all is sharp when distance_m is 0.
struct FocusModel {
  double focal_length_m = 0.0, f_number = 0.0, distance_m = 0.0, pixel_pitch_m = 0.0;
};

/// The stereo pair as drawn in the workshop, and how far the built one may be off (1 sigma each).
struct StereoModel {
  StereoRig nominal;
  double relative_yaw_sigma_rad = 0.0;  // right against left camera
  double rotation_sigma_rad = 0.0;      // each camera, roll and pitch
  double focal_sigma = 0.0;             // relative
  double centre_sigma_px = 0.0;
  double radial_sigma_px = 0.0;  // lens's radial term, at the middle of the image's left edge
  // Sensor
  double full_well_e = 0.0, read_noise_e = 0.0;
  double vignetting_exponent = 0.0;  // irradiance falls as cos^n of the angle off axis
  double blur_sigma_px = 0.0;        // lens and pixel together
  double response_sigma = 0.0;       // of pixels among each other
  int bits = 8;                      // of a pixel; the controller gets the upper eight
  ExposureModel exposure;
  FocusModel focus;
};

struct RoverModel {
  std::string name;
  LinkModel body, left_wheel, right_wheel, arm;
  Eigen::Vector3d p_R_left_wheel{0, 0, 0}, p_R_right_wheel{0, 0, 0};  // wheel centres in the body
  // The arm turns about the body's y axis through its origin. Link frame: A.
  double arm_lower_rad = 0.0, arm_upper_rad = 0.0;  // joint limits, tip-down positive
  double arm_length_m = 0.0;                        // axle to the tip's front face
  double arm_at_power_on_rad = 0.0;                 // stowed against the body, tip-down positive
  WheelModel left_wheel_soil, right_wheel_soil;
  std::array<MotorModel, kMotorCount> motors;  // by Motor
  TetherModel tether;
  ArmTipModel tip;
  CollarModel collar;
  ImuModel imu;
  StereoModel stereo;

  double mass_kg() const {
    return body.mass_kg + left_wheel.mass_kg + right_wheel.mass_kg + arm.mass_kg;
  }
};

}  // namespace dockyard
