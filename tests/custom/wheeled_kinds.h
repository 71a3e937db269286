// Wheeled robots of several kinds as their users write them: a URDF, and a YAML file of 40 lines.
#pragma once

#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "support/bad_files.h"
#include "support/urdf_text.h"

namespace dockyard::custom {

inline std::string BoxLink(const std::string& name, double mass_kg, const Eigen::Vector3d& size,
                           const std::string& origin = "0 0 0") {
  return "<link name=\"" + name + "\">" + InertialOfBox(mass_kg, size) +
         "<collision><origin xyz=\"" + origin + "\"/>" + BoxGeometry(size) +
         "</collision></link>\n";
}

/// A wheel about y on a continuous joint "NAME_joint".
inline std::string WheelOn(const std::string& parent, const std::string& name,
                           const std::string& xyz, double radius_m, double width_m) {
  const std::string cylinder =
      "<origin rpy=\"1.5707963267948966 0 0\"/><geometry><cylinder radius=\"" +
      NumberText(radius_m) + "\" length=\"" + NumberText(width_m) + "\"/></geometry>";
  return "<link name=\"" + name + "\">" +
         InertialOfBox(0.3, {1.5 * radius_m, width_m, 1.5 * radius_m}) + "<collision>" + cylinder +
         "</collision></link>\n<joint name=\"" + name +
         "_joint\" type=\"continuous\"><parent link=\"" + parent + "\"/><child link=\"" + name +
         "\"/><origin xyz=\"" + xyz + "\"/><axis xyz=\"0 1 0\"/></joint>\n";
}

/// A swivel "NAME_swivel" with a wheel that trails by 30 mm.
inline std::string CasterOn(const std::string& parent, const std::string& name,
                            const std::string& xyz, double radius_m) {
  return BoxLink(name + "_fork", 0.1, {0.03, 0.03, 0.03}, "0 0 0.03") + "<joint name=\"" + name +
         "_swivel\" type=\"continuous\"><parent link=\"" + parent + "\"/><child link=\"" + name +
         "_fork\"/><origin xyz=\"" + xyz + "\"/><axis xyz=\"0 0 1\"/></joint>\n" +
         WheelOn(name + "_fork", name + "_wheel", "-0.03 0 -0.02", radius_m, 0.02);
}

inline std::string BallOn(const std::string& parent, const std::string& name,
                          const std::string& xyz, double radius_m) {
  return "<link name=\"" + name + "\"><collision><geometry><sphere radius=\"" +
         NumberText(radius_m) + "\"/></geometry></collision></link>\n<joint name=\"" + name +
         "_joint\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" + name +
         "\"/><origin xyz=\"" + xyz + "\"/></joint>\n";
}

struct RobotText {
  std::string urdf, yaml;
};

/// driven: their names, those on the left first; others: further lines of the list `wheels`.
inline std::string RobotYaml(const std::vector<std::string>& driven, const std::string& others) {
  std::string links, joints;
  for (const std::string& name : driven) {
    links += (links.empty() ? "" : ", ") + name;
    joints += (joints.empty() ? "" : ", ") + name + "_joint";
  }
  return "name: kind\nurdf: robot.urdf\nwheels:\n  - links: [" + links +
         "]\n    tyre: {rolling_resistance_m: 0.001}\n" + others + "motors:\n  - joints: [" +
         joints +
         "]\n    torque_per_amp_nm: 1.0\n    no_load_current_a: 0.2\n    max_current_a: 10\n"
         "    gear_friction_nm: 0.05\n    brake_torque_nm: 5\n    max_speed_rad_s: 15\n"
         "    max_accel_rad_s2: 20\n    reflected_inertia_kg_m2: 0.01\n    counts_per_rev: 4096\n"
         "    current_noise_a: 0.02\n";
}

inline std::string Robot(const std::string& parts) {
  return "<robot name=\"kind\">\n" + parts + "</robot>\n";
}

/// After the TurtleBot 3 Burger's layout: two driven wheels and a ball behind.
inline RobotText TwoWheelsAndABall() {
  return {Robot(BoxLink("base_link", 1.5, {0.14, 0.14, 0.1}, "-0.03 0 0.05") +
                WheelOn("base_link", "left_wheel", "0 0.08 0", 0.033, 0.018) +
                WheelOn("base_link", "right_wheel", "0 -0.08 0", 0.033, 0.018) +
                BallOn("base_link", "ball", "-0.08 0 -0.023", 0.01)),
          RobotYaml({"left_wheel", "right_wheel"},
                    "  - links: [ball]\n    tyre: {ball: true, grip: 0.2, "
                    "rolling_resistance_m: 0}\n")};
}

inline RobotText TwoWheelsAndTwoCasters() {
  return {Robot(BoxLink("base_link", 20.0, {0.6, 0.4, 0.2}, "0 0 0.1") +
                WheelOn("base_link", "left_wheel", "0 0.2 0", 0.0625, 0.03) +
                WheelOn("base_link", "right_wheel", "0 -0.2 0", 0.0625, 0.03) +
                CasterOn("base_link", "front", "0.25 0 -0.0025", 0.04) +
                CasterOn("base_link", "rear", "-0.25 0 -0.0025", 0.04)),
          RobotYaml({"left_wheel", "right_wheel"},
                    "  - links: [front_wheel, rear_wheel]\n    tyre: {grip: 0.7}\n")};
}

/// After the Jackal's layout.
inline RobotText FourFixedWheels() {
  return {Robot(BoxLink("base_link", 15.0, {0.42, 0.3, 0.18}, "0 0 0.08") +
                WheelOn("base_link", "front_left", "0.13 0.19 0", 0.098, 0.04) +
                WheelOn("base_link", "rear_left", "-0.13 0.19 0", 0.098, 0.04) +
                WheelOn("base_link", "front_right", "0.13 -0.19 0", 0.098, 0.04) +
                WheelOn("base_link", "rear_right", "-0.13 -0.19 0", 0.098, 0.04)),
          RobotYaml({"front_left", "rear_left", "front_right", "rear_right"}, "")};
}

inline RobotText SixFixedWheels() {
  return {
      Robot(BoxLink("base_link", 30.0, {0.7, 0.4, 0.2}, "0 0 0.1") +
            WheelOn("base_link", "front_left", "0.25 0.25 0", 0.1, 0.05) +
            WheelOn("base_link", "mid_left", "0 0.25 0", 0.1, 0.05) +
            WheelOn("base_link", "rear_left", "-0.25 0.25 0", 0.1, 0.05) +
            WheelOn("base_link", "front_right", "0.25 -0.25 0", 0.1, 0.05) +
            WheelOn("base_link", "mid_right", "0 -0.25 0", 0.1, 0.05) +
            WheelOn("base_link", "rear_right", "-0.25 -0.25 0", 0.1, 0.05)),
      RobotYaml({"front_left", "mid_left", "rear_left", "front_right", "mid_right", "rear_right"},
                "")};
}

}  // namespace dockyard::custom
