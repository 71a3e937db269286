// Axel with links of its own design: what a user adds to the files.
#pragma once

#include <string>

#include "models/axel/load_axel.h"
#include "support/bad_files.h"
#include "support/urdf_text.h"

namespace dockyard::axel {

/// Text of a URDF link that is a solid box about its own origin, drawn and touched as one.
inline std::string SolidLink(const std::string& name, double mass_kg, const Eigen::Vector3d& size,
                             bool touches = true) {
  const std::string box = BoxGeometry(size);
  return "<link name=\"" + name + "\">" + InertialOfBox(mass_kg, size) + "<visual>" + box +
         "</visual>" + (touches ? "<collision>" + box + "</collision>" : "") + "</link>\n";
}

/// Text of a joint named "to_CHILD". more: further elements.
inline std::string JointTo(const std::string& child, const std::string& parent,
                           const std::string& type, const std::string& xyz, const std::string& axis,
                           const std::string& more = "") {
  return "<joint name=\"to_" + child + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"" + xyz + "\"/><axis xyz=\"" + axis +
         "\"/>" + more + "</joint>\n";
}

/// Keys of a small motor, two more deep than `indent`.
inline std::string SmallMotor(const std::string& indent) {
  std::string text = indent + "motor:\n";
  for (const char* key :
       {"torque_per_amp_nm: 4", "no_load_current_a: 0.05", "max_current_a: 3",
        "gear_friction_nm: 0.3", "brake_torque_nm: 6", "max_speed_rad_s: 2", "max_accel_rad_s2: 1",
        "reflected_inertia_kg_m2: 0.05", "counts_per_rev: 51200", "current_noise_a: 0"}) {
    text += indent + "  " + key + "\n";
  }
  return text;
}

/// Axel's files with this at the ends of the URDF and the YAML.
inline RoverModel AxelWith(const std::string& urdf, const std::string& yaml) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string path = "models/axel/axel";
  folder.Write(path + ".urdf",
               Replaced(Slurp(SourceFile(path + ".urdf")), "</robot>", urdf + "</robot>"));
  folder.Write(path + ".yaml", Slurp(SourceFile(path + ".yaml")) + "\n" + yaml);
  return LoadRover((folder.path() / (path + ".yaml")).string());
}

}  // namespace dockyard::axel
