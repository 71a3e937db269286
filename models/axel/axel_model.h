// Axel, the two-wheeled tethered rover, as built: URDF for the parts that it can describe, YAML for
// the rest.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "controller/axel/nominal/motors.h"
#include "models/parts/cameras.h"
#include "models/parts/contact_material.h"
#include "models/parts/imu.h"
#include "models/parts/joint_stop.h"
#include "models/parts/jointed_link.h"
#include "models/parts/link.h"
#include "models/parts/motor.h"
#include "models/parts/tether.h"
#include "models/parts/tether_sensor.h"
#include "models/parts/wheel.h"

namespace dockyard::axel {

struct ArmTipModel {
  double radius_m = 0.0;         // of the flat-nosed tip cylinder
  double length_m = 0.0;         // of the thick tip part
  double ground_friction = 0.0;  // dragging over soil
  double ground_stiffness_n_per_m = 0.0;
  double ground_damping_ratio = 0.3;  // share of critical; assumed, 0.1-0.5
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

struct RoverModel {
  std::string name;
  LinkModel body, left_wheel, right_wheel, arm;
  JointedLinks further;  // which carry no part that the controller knows of
  Eigen::Vector3d p_R_left_wheel{0, 0, 0}, p_R_right_wheel{0, 0, 0};  // wheel centres in the body
  // The arm turns about the body's y axis through its origin. Link frame: A.
  // End stops, tip-down positive; infinite: it turns round and round.
  double arm_lower_rad = -std::numeric_limits<double>::infinity();
  double arm_upper_rad = std::numeric_limits<double>::infinity();
  // Of such a stop: stiff rubber (assumed, range 1e3-1e4 Nm/rad), and a fifth of critical damping
  // on the arm and its rotor, 3.3 kg m^2 (assumed, range 20-250 Nm s/rad).
  JointStop arm_stop{.stiffness_nm_per_rad = 5e3, .damping_nms_per_rad = 50.0};
  double arm_length_m = 0.0;         // axle to the tip's front face
  double arm_at_power_on_rad = 0.0;  // stowed against the body, tip-down positive
  WheelModel left_wheel_soil, right_wheel_soil;
  std::array<MotorModel, kMotorCount> motors;  // by Motor
  TetherModel tether;
  std::optional<TetherSensorModel> tether_sensor{};
  // Of a line of contact with rock, which has the friction. Assumed: models/axel/axel.yaml.
  ContactMaterial rock_contact{.stiffness_n_per_m = 5e5, .damping_ns_per_m = 1.3e3};
  ArmTipModel tip;
  CollarModel collar;
  ImuModel imu;
  StereoModel stereo;

  double track_m() const { return p_R_left_wheel.y() - p_R_right_wheel.y(); }
  double mass_kg() const {
    return body.mass_kg + left_wheel.mass_kg + right_wheel.mass_kg + arm.mass_kg +
           further.mass_kg();
  }
};

}  // namespace dockyard::axel
