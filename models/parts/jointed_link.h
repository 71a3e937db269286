// Links that a robot has beyond those that its system commands, such as a mast or a trailer. Each
// hangs on a joint that turns or slides, free or by a motor of its own.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "models/parts/contact_material.h"
#include "models/parts/joint_stop.h"
#include "models/parts/link.h"
#include "models/parts/motor.h"

namespace dockyard {

/// A motor that needs no controller: it runs to and fro between its joint's limits.
struct JointMotor {
  MotorModel model;
  double rate_rad_s = 0.0;       // of the joint, in m/s where it slides; 0: the brake holds it
  double lead_m_per_turn = 0.0;  // of a slide's screw: travel for a turn of the motor's output
};

/// Of a slide [N/m, N s/m]: 10 kg fall on it by 1 mm; assumed, 1e4-1e6 and 50-5000.
inline constexpr JointStop kSlideStop{.stiffness_nm_per_rad = 1e5, .damping_nms_per_rad = 500.0};

/// A link and its joint. "Angle" is a slide's travel as well [m], "torque" its force [N].
struct JointedLink {
  LinkModel link;
  std::string joint;                // the name
  int carrier = 0;                  // its number among all links of the robot, these last
  Pose3 X_PL;                       // in the carrier's frame, at angle 0
  Eigen::Vector3d axis_L{0, 0, 1};  // unit
  bool slides = false;
  double low_rad = -std::numeric_limits<double>::infinity();
  double high_rad = std::numeric_limits<double>::infinity();
  // Stiff rubber, as of Axel's arm; assumed, 1e3-1e5 and 5-250. A slide has kSlideStop.
  JointStop stop{.stiffness_nm_per_rad = 5e3, .damping_nms_per_rad = 50.0};
  double damping_nms_per_rad = 0.0, friction_nm = 0.0;  // of the joint; friction is Coulomb's
  double spring_nm_per_rad = 0.0, rest_rad = 0.0;       // of its spring, free at rest_rad
  double start_rad = 0.0;
  std::optional<JointMotor> motor;  // none: free
};

/// A joint that follows another one: angle = ratio * the other's + offset_rad.
struct JointRatio {
  int link = 0, other = 0;  // which the joints carry, among all links of the robot
  double ratio = 1.0, offset_rad = 0.0;
};

/// A ball joint between two links, which closes a loop of the tree.
struct LinkPin {
  int a = 0, b = 0;                // among all links of the robot
  Eigen::Vector3d p_A{0, 0, 0};    // in a's frame; where b has it follows from the start
  double stiffness_n_per_m = 1e6;  // of a steel pin in its bore; assumed, 1e5-1e7
  double damping_ns_per_m = 1e3;   // of the same; assumed, 1e2-1e4
};

struct JointedLinks {
  std::vector<JointedLink> links;  // each after its carrier
  std::vector<JointRatio> ratios;  // each after those of the joint that it follows
  std::vector<LinkPin> pins;
  // Where one of the links touches another link of the robot. Metal on metal: assumed, range
  // 1e5-1e7, 1e2-1e4 and 0.2-0.6.
  ContactMaterial contact{.stiffness_n_per_m = 5e5, .damping_ns_per_m = 1.3e3, .friction = 0.4};

  bool empty() const { return links.empty(); }
  double mass_kg() const {
    double sum_kg = 0.0;
    for (const JointedLink& each : links) sum_kg += each.link.mass_kg;
    return sum_kg;
  }
};

}  // namespace dockyard
