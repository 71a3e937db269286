#include "models/read/urdf_elements.h"

#include <algorithm>
#include <set>
#include <vector>

#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

/// The allowed content of an element. `once` holds the children that may not be repeated, `must`
/// those of them that may not be missing.
struct Rule {
  std::vector<std::string> attributes, once, any, must = {};
};

const std::map<std::string, Rule>& Rules() {
  static const std::map<std::string, Rule> rules{
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
      {"joint", {{"name", "type"}, {"origin", "parent", "child", "axis", "limit", "dynamics"}, {}}},
      {"parent", {{"link"}, {}, {}}},
      {"child", {{"link"}, {}, {}}},
      {"axis", {{"xyz"}, {}, {}}},
      {"limit", {{"lower", "upper", "effort", "velocity"}, {}, {}}},
      {"dynamics", {{"damping", "friction"}, {}, {}}}};
  return rules;
}

/// Change nothing here: notes for other programs, and where an encoder's mark sits.
bool IsLeftOut(const std::string& parent, const std::string& name) {
  static const std::set<std::string> of_robot{"gazebo", "transmission", "ros2_control"};
  return (parent == "robot" && of_robot.count(name) > 0) ||
         (parent == "joint" && name == "calibration");
}

/// Why a known element of URDF is refused; empty for any other.
std::string ReasonAgainst(const std::string& name) {
  static const std::map<std::string, std::string> reasons{
      {"mimic", "joints that follow another are not simulated"},
      {"safety_controller", "its soft limits are not simulated; <limit> is"},
      {"texture", "textures are not drawn; a <color> is"},
      {"capsule", "capsules are not read; a cylinder and two spheres are"},
      {"sensor", "sensors are described in the robot's YAML file"}};
  if (name.rfind("xacro:", 0) == 0) return "macros are not expanded; run xacro first";
  const auto at = reasons.find(name);
  return at == reasons.end() ? std::string() : at->second;
}

bool Contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

class ElementCheck {
 public:
  explicit ElementCheck(std::string file) : file_(std::move(file)) {}

  void Visit(const TiXmlElement& element) {
    const std::string name = element.Value();
    const Rule& rule = Rules().at(name);
    CheckAttributes(element, rule);
    std::set<std::string> seen;
    for (const TiXmlElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string child = e->Value();
      if (IsLeftOut(name, child)) {
        ++left_out_[child];
        continue;
      }
      const bool once = Contains(rule.once, child);
      if (!once && !Contains(rule.any, child)) RefuseChild(*e, name, rule);
      if (once && !seen.insert(child).second) Refuse(*e, "given twice in one <" + name + ">");
      Visit(*e);
    }
    for (const std::string& needed : rule.must) {
      if (seen.count(needed) == 0) Refuse(element, "missing <" + needed + ">");
    }
    if (name == "geometry" && seen.size() != 1) {
      Refuse(element, "expected one shape, found " + std::to_string(seen.size()));
    }
    CheckValues(element, name);
    if (name == "material") TakeMaterial(element);
  }

  /// Materials of the robot hold for all links, wherever they stand.
  void TakeMaterials(const TiXmlElement& robot) {
    for (const TiXmlElement* e = robot.FirstChildElement("material"); e;
         e = e->NextSiblingElement("material")) {
      const char *name = e->Attribute("name"), *rgba = ColourOf(*e);
      if (name != nullptr && rgba != nullptr) colours_.emplace(name, rgba);
    }
  }

  std::map<std::string, int> TakeLeftOut() { return std::move(left_out_); }

 private:
  [[noreturn]] void Refuse(const TiXmlElement& at, const std::string& what) const {
    throw ConfigError(file_ + ":" + std::to_string(at.Row()) + ":" + std::to_string(at.Column()) +
                      ": <" + at.Value() + ">: " + what);
  }

  /// "unknown X in <Y>, did you mean 'a'?"
  static std::string Unknown(const std::string& kind, const std::string& found,
                             const std::string& parent, const std::vector<std::string>& known) {
    std::string text = "unknown " + kind + " in <" + parent + ">";
    const std::string near = NearestName(found, known);
    if (!near.empty()) return text + ", did you mean '" + near + "'?";
    if (known.empty()) return text + ", which has none";
    text += ", known are: ";
    for (std::size_t i = 0; i < known.size(); ++i) text += (i > 0 ? ", " : "") + known[i];
    return text;
  }

  [[noreturn]] void RefuseChild(const TiXmlElement& child, const std::string& parent,
                                const Rule& rule) const {
    const std::string reason = ReasonAgainst(child.Value());
    if (!reason.empty()) Refuse(child, reason);
    std::vector<std::string> known = rule.any;
    known.insert(known.end(), rule.once.begin(), rule.once.end());
    Refuse(child, Unknown("element", child.Value(), parent, known));
  }

  void CheckAttributes(const TiXmlElement& element, const Rule& rule) const {
    for (const TiXmlAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
      const std::string name = a->Name();
      if (Contains(rule.attributes, name) || name.rfind("xmlns", 0) == 0) continue;
      Refuse(element, name + ": " + Unknown("attribute", name, element.Value(), rule.attributes));
    }
  }

  void CheckValues(const TiXmlElement& element, const std::string& name) const {
    if (name == "dynamics") {
      for (const char* attribute : {"damping", "friction"}) {
        const char* text = element.Attribute(attribute);
        double value = 0.0;
        if (text == nullptr || (ParseNumber(text, value) && value == 0.0)) continue;
        Refuse(element,
               std::string(attribute) +
                   ": expected 0, the robot's YAML file has the motors' friction; found '" + text +
                   "'");
      }
    }
    if (name == "color") {
      const std::string rgba = element.Attribute("rgba") ? element.Attribute("rgba") : "";
      const std::size_t last = rgba.find_last_not_of(" \t\r\n");
      const std::size_t gap = rgba.find_last_of(" \t\r\n", last);
      double alpha = 0.0;
      const bool opaque = last != std::string::npos && gap != std::string::npos &&
                          ParseNumber(rgba.substr(gap + 1, last - gap), alpha) && alpha == 1.0;
      if (!opaque)
        Refuse(element, "rgba: expected a last number of 1, nothing is drawn transparent");
    }
  }

  static const char* ColourOf(const TiXmlElement& material) {
    const TiXmlElement* color = material.FirstChildElement("color");
    return color == nullptr ? nullptr : color->Attribute("rgba");
  }

  /// One name is one colour: a parser takes the first for all.
  void TakeMaterial(const TiXmlElement& material) {
    const std::string name = material.Attribute("name") ? material.Attribute("name") : "";
    const char* rgba = ColourOf(material);
    if (rgba != nullptr && name.empty()) return;
    if (rgba == nullptr && colours_.count(name) == 0) {
      Refuse(material,
             "expected a <color>, or the name of a material before, found '" + name + "'");
    }
    if (rgba == nullptr || colours_.emplace(name, rgba).first->second == rgba) return;
    Refuse(material, "'" + name + "' has another colour before");
  }

  std::string file_;
  std::map<std::string, std::string> colours_;  // by material
  std::map<std::string, int> left_out_;
};

}  // namespace

std::map<std::string, int> CheckUrdfElements(const TiXmlElement& robot, const std::string& file) {
  ElementCheck check(file);
  check.TakeMaterials(robot);
  check.Visit(robot);
  return check.TakeLeftOut();
}

}  // namespace dockyard
