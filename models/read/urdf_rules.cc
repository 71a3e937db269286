#include "models/read/urdf_rules.h"

#include <map>
#include <set>

namespace dockyard {
namespace {

const std::map<std::string, UrdfRule>& Rules() {
  static const std::map<std::string, UrdfRule> rules{
      {"robot", {{"name", "version"}, {}, {"link", "joint", "material"}}},
      {"link", {{"name"}, {"inertial"}, {"visual", "collision"}}},
      {"inertial", {{}, {"origin", "mass", "inertia"}, {}, {"mass", "inertia"}}},
      {"origin", {{"xyz", "rpy"}, {}, {}}},
      {"mass", {{"value"}, {}, {}}},
      {"inertia", {{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}, {}, {}}},
      {"visual", {{"name"}, {"origin", "geometry", "material"}, {}, {"geometry"}}},
      {"collision", {{"name"}, {"origin", "geometry"}, {}, {"geometry"}}},
      {"geometry", {{}, {"box", "cylinder", "sphere", "mesh"}, {}}},
      {"box", {{"size"}, {}, {}}},
      {"cylinder", {{"radius", "length"}, {}, {}}},
      {"sphere", {{"radius"}, {}, {}}},
      {"mesh", {{"filename", "scale"}, {}, {}}},
      {"material", {{"name"}, {"color"}, {}}},
      {"color", {{"rgba"}, {}, {}}},
      {"joint",
       {{"name", "type"}, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"}, {}}},
      {"parent", {{"link"}, {}, {}}},
      {"child", {{"link"}, {}, {}}},
      {"axis", {{"xyz"}, {}, {}}},
      {"limit", {{"lower", "upper", "effort", "velocity"}, {}, {}}},
      {"dynamics", {{"damping", "friction"}, {}, {}}},
      {"mimic", {{"joint", "multiplier", "offset"}, {}, {}}}};
  return rules;
}

/// Notes for other programs, where an encoder's mark sits, and friction of contacts, which the
/// robot's YAML file has; by the elements that hold them.
const std::map<std::string, std::set<std::string>>& LeftOut() {
  static const std::map<std::string, std::set<std::string>> left_out{
      {"robot", {"gazebo", "transmission", "ros2_control", "mujoco", "sensor"}},
      {"link", {"gazebo", "sensor", "contact", "contact_coefficients"}},
      {"joint", {"gazebo", "calibration", "joint_properties"}},
      {"visual", {"gazebo", "surface", "map", "verbose"}},
      {"collision",
       {"gazebo", "surface", "material", "contact", "contact_coefficients", "map", "verbose"}},
      {"geometry", {"gazebo", "surface", "material"}}};
  return left_out;
}

/// Attributes without effect, by element.
const std::map<std::string, std::set<std::string>>& LeftOutAttributes() {
  static const std::map<std::string, std::set<std::string>> left_out{{"link", {"type"}},
                                                                     {"geometry", {"name"}}};
  return left_out;
}

}  // namespace

const UrdfRule& RuleOfUrdf(const std::string& element) { return Rules().at(element); }

bool IsLeftOutOfUrdf(const std::string& parent, const TiXmlElement& element) {
  const std::string name = element.Value();
  const auto of_parent = LeftOut().find(parent);
  if (of_parent != LeftOut().end() && of_parent->second.count(name) > 0) return true;
  const auto is_empty = [&](const char* attribute) {
    const char* text = element.Attribute(attribute);
    return (text == nullptr || *text == '\0') && element.FirstChild() == nullptr;
  };
  return (name == "texture" && is_empty("filename")) ||
         (name == "material" && parent == "visual" && is_empty("name"));
}

bool IsLeftOutAttribute(const std::string& element, const std::string& attribute) {
  const auto of_element = LeftOutAttributes().find(element);
  return of_element != LeftOutAttributes().end() && of_element->second.count(attribute) > 0;
}

std::string ReasonAgainstInUrdf(const std::string& name) {
  static const std::map<std::string, std::string> reasons{
      {"safety_controller", "its soft limits are not simulated; <limit> is"},
      {"texture", "textures are not drawn; a <color> is"},
      {"capsule", "capsules are not read; a cylinder and two spheres are"}};
  const auto at = reasons.find(name);
  return at == reasons.end() ? std::string() : at->second;
}

}  // namespace dockyard
