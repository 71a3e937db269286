// RAPOSA as built: URDF for the parts that it can describe, YAML for the rest.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "controller/geometry/camera.h"
#include "controller/raposa/nominal/motors.h"
#include "models/parts/contact_material.h"
#include "models/parts/imu.h"
#include "models/parts/joint_stop.h"
#include "models/parts/link.h"
#include "models/parts/motor.h"

namespace dockyard::raposa {

/// Main belts on the body, belts on the arm. The arm's rear rollers sit on its joint.
struct BeltsModel {
  double gauge_m = 0.0;  // between the middles of left and right belts
  double width_m = 0.0;
  double roller_radius_m = 0.0;
  double body_rear_m = 0.0, body_front_m = 0.0;  // x of the rollers in R
  double arm_length_m = 0.0;                     // joint to tip roller
  // Of rubber and floor, per area that touches: along the normal and along the ground.
  double stiffness_pa_per_m = 0.0, damping_pa_s_per_m = 0.0;
  double shear_stiffness_pa_per_m = 0.0, shear_damping_pa_s_per_m = 0.0;
  double effective_gauge_m = 0.0;  // as the controller is told
  double speed_offset = 0.0;       // share of full speed, 1 sigma
  double drift_time_s = 0.0;       // of that offset
  double dead_band_m_s = 0.0;
};

/// Metal or stiff plastic: 100 N press it in by 20 um; damped by 0.3 of critical on the pyramid's
/// mass, as is its rebound. Assumed, 1e6-1e7 N/m, 300-3000 N s/m, 0.1-0.3.
inline constexpr ContactMaterial kHardContact{5e6, 1e3, 0.2, 0.0};

struct DoorsModel {
  double pinion_radius_m = 0.0;
  double travel_m = 0.0;  // of each
  double plate_m = 0.0;
  double closed_radius_m = 0.0;  // of the circle in the square that both V leave
  JointStop stop;                // at both ends of a door's travel
  ContactMaterial contact = kHardContact;
};

/// Turned about the seat's axis, which is R's x axis through the seat.
struct SocketModel {
  Eigen::Vector3d p_RS{0, 0, 0};  // the guide's middle once docked
  double entrance_radius_m = 0.0, throat_radius_m = 0.0;
  double seat_radius_m = 0.0;              // of the seat's cone at the guide's middle
  double half_angle_rad = 0.0;             // of funnel and seat
  ContactMaterial contact = kHardContact;  // of the body
};

struct BackCameraModel {
  Camera camera;
  Pose3 X_RC;
  double half_view_rad = 0.0, hole_m = 0.0;
  double delay_s = 0.0;  // at most a control period
  double shutter_s = 0.0;
  double blur_sigma_px = 0.0, full_well_e = 0.0, read_noise_e = 0.0, vignetting_exponent = 0.0;
  double exposed_level = 0.0;  // mean green of what it sees, as a share of the full well
};

/// Two white light diodes, beside each other, shining to the back.
struct LampsModel {
  Eigen::Vector3d p_R{0, 0, 0};  // middle of both
  double apart_m = 0.0;
  double irradiance_at_1m = 0.0;
  double half_angle_rad = 0.0;
};

struct RobotModel {
  std::string name;
  LinkModel body, arm, left_door, right_door;
  Eigen::Vector3d p_R_arm{0, 0, 0};                 // the arm's joint, about y
  Eigen::Vector3d p_R_doors{0, 0, 0};               // the middle of the doors' V when closed
  double arm_lower_rad = 0.0, arm_upper_rad = 0.0;  // tip-down positive
  JointStop arm_stop;
  BeltsModel belts;
  std::array<MotorModel, kMotorCount> motors;  // by Motor
  DoorsModel doors;
  SocketModel socket;
  BackCameraModel camera;
  LampsModel lamps;
  std::optional<ImuModel> imu;  // the paper's robot has none

  double mass_kg() const {
    return body.mass_kg + arm.mass_kg + left_door.mass_kg + right_door.mass_kg;
  }
};

}  // namespace dockyard::raposa
