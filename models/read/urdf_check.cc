#include "models/read/urdf_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "models/read/config_error.h"
#include "models/read/urdf_elements.h"
#include "models/read/urdf_numbers.h"
#include "models/read/urdf_rules.h"
#include "models/read/urdf_tree.h"
#include "models/read/xml_scan.h"

namespace dockyard {
namespace {

/// Attributes that hold numbers, and how many; `value` only counts in <mass>.
const std::vector<std::pair<std::string, std::size_t>>& NumberAttributes() {
  static const std::vector<std::pair<std::string, std::size_t>> attributes{
      {"xyz", 3},    {"rpy", 3},      {"size", 3},    {"scale", 3},    {"rgba", 4},
      {"radius", 1}, {"length", 1},   {"ixx", 1},     {"ixy", 1},      {"ixz", 1},
      {"iyy", 1},    {"iyz", 1},      {"izz", 1},     {"lower", 1},    {"upper", 1},
      {"effort", 1}, {"velocity", 1}, {"damping", 1}, {"friction", 1}, {"multiplier", 1},
      {"offset", 1}};
  return attributes;
}

class XmlCheck {
 public:
  explicit XmlCheck(UrdfFaults& faults) : faults_(faults) {}

  std::map<std::string, int> Run(TiXmlElement& robot) {
    for (const TiXmlElement* e = robot.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string_view tag = e->Value();
      if (tag == "link" || tag == "joint") TakeName(*e);
      if (tag == "link" || tag == "joint" || tag == "material") CheckNumbers(*e);
    }
    for (const TiXmlElement* e = robot.FirstChildElement("joint"); e;
         e = e->NextSiblingElement("joint")) {
      CheckJoint(*e);
    }
    const std::map<std::string, int> left_out = CheckUrdfElements(robot, faults_);
    if (names_and_ends_) CheckUrdfTree(robot, faults_);
    return left_out;
  }

 private:
  void TakeName(const TiXmlElement& element) {
    const char* name = element.Attribute("name");
    if (name == nullptr || *name == '\0') return Break(element, "missing attribute 'name'");
    const auto [at, fresh] =
        names_.emplace(std::string(element.Value()) + " " + name, faults_.PlaceOf(element));
    if (!fresh)
      Break(element, std::string("'") + name + "' is given twice, first at " + at->second);
  }

  /// A fault after which there is no tree to check.
  void Break(const TiXmlElement& at, const std::string& what) {
    names_and_ends_ = false;
    faults_.Add(at, what);
  }

  void CheckNumbers(const TiXmlElement& element) const {
    const bool mass = std::string_view(element.Value()) == "mass";
    if (mass) CheckList(element, "value", 1);
    for (const auto& [name, count] : NumberAttributes()) CheckList(element, name, count);
    for (const TiXmlElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
      if (!IsLeftOutOfUrdf(element.Value(), *e)) CheckNumbers(*e);
    }
  }

  /// More than a turn is one in degrees.
  void CheckTurns(const TiXmlElement& element, const std::string& name,
                  const std::vector<double>& numbers) const {
    constexpr double kTurn_rad = 6.2832;
    const bool turns = std::any_of(numbers.begin(), numbers.end(),
                                   [](double angle) { return std::abs(angle) > kTurn_rad; });
    if (name != "rpy" || !turns) return;
    faults_.Add(element, std::string("rpy: expected angles in radians, up to a turn, found '") +
                             element.Attribute("rpy") + "'");
  }

  void CheckList(const TiXmlElement& element, const std::string& name, std::size_t count) const {
    const char* attribute = element.Attribute(name.c_str());
    if (attribute == nullptr) return;
    const std::optional<std::vector<double>> numbers = NumbersOf(attribute);
    if (numbers && numbers->size() == count) return CheckTurns(element, name, *numbers);
    const std::string expected = count == 1 ? "a number" : std::to_string(count) + " numbers";
    faults_.Add(element, name + ": expected " + expected + ", found '" +
                             std::string(attribute).substr(0, 60) + "'");
  }

  void CheckJoint(const TiXmlElement& joint) {
    const char* type = joint.Attribute("type");
    static const std::vector<std::string> types{"continuous", "fixed",     "floating",
                                                "planar",     "prismatic", "revolute"};
    if (type == nullptr || std::find(types.begin(), types.end(), type) == types.end()) {
      faults_.Add(joint,
                  std::string("type: expected continuous, fixed, floating, planar, prismatic or "
                              "revolute, found '") +
                      (type == nullptr ? "" : type) + "'");
      type = "";
    }
    for (const char* end : {"parent", "child"}) {
      const TiXmlElement* element = joint.FirstChildElement(end);
      const char* link = element == nullptr ? nullptr : element->Attribute("link");
      if (link == nullptr) {
        Break(joint, std::string("missing <") + end + " link=\"...\"/>");
      } else if (names_.count(std::string("link ") + link) == 0) {
        Break(*element, std::string("expected the name of a link, found '") + link + "'");
      }
    }
    const bool bounded =
        std::string_view(type) == "revolute" || std::string_view(type) == "prismatic";
    if (bounded && joint.FirstChildElement("limit") == nullptr)
      faults_.Add(joint, "missing <limit>");
  }

  UrdfFaults& faults_;
  std::map<std::string, std::string> names_;  // "link NAME" or "joint NAME" -> its place
  bool names_and_ends_ = true;                // have no fault
};

}  // namespace

std::unique_ptr<TiXmlDocument> ParseUrdfXml(const std::string& text, const std::string& name) {
  // Keeps the recursive XML parser within its stack and its time.
  if (const std::optional<XmlFault> fault = ScanXml(text)) {
    throw ConfigError(name + ":" + LineAndColumn(text, fault->at) +
                      ": not usable XML: " + fault->what);
  }
  auto document = std::make_unique<TiXmlDocument>();
  document->Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document->Error()) {
    throw ConfigError(name + ":" + std::to_string(std::max(1, document->ErrorRow())) + ":" +
                      std::to_string(std::max(1, document->ErrorCol())) +
                      ": not valid XML: " + document->ErrorDesc());
  }
  if (document->FirstChildElement("robot") == nullptr) {
    throw ConfigError(name + ":1:1: expected a <robot> element, found none");
  }
  return document;
}

std::map<std::string, int> CheckUrdfXml(TiXmlElement& robot, UrdfFaults& faults) {
  return XmlCheck(faults).Run(robot);
}

}  // namespace dockyard
