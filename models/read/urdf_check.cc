#include "models/read/urdf_check.h"

#include <tinyxml.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "models/read/config_error.h"
#include "models/read/urdf_elements.h"
#include "models/read/urdf_tree.h"
#include "models/read/xml_scan.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

/// Attributes that hold numbers, and how many; `value` only counts in <mass>.
const std::vector<std::pair<std::string, std::size_t>>& NumberAttributes() {
  static const std::vector<std::pair<std::string, std::size_t>> attributes{
      {"xyz", 3},    {"rpy", 3},      {"size", 3},    {"scale", 3},   {"rgba", 4},
      {"radius", 1}, {"length", 1},   {"ixx", 1},     {"ixy", 1},     {"ixz", 1},
      {"iyy", 1},    {"iyz", 1},      {"izz", 1},     {"lower", 1},   {"upper", 1},
      {"effort", 1}, {"velocity", 1}, {"damping", 1}, {"friction", 1}};
  return attributes;
}

class XmlCheck {
 public:
  explicit XmlCheck(std::string file) : file_(std::move(file)) {}

  UrdfText Run(const std::string& text) {
    CheckNesting(text);
    TiXmlDocument document;
    document.Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
    if (document.Error()) {
      throw ConfigError(Place(std::max(1, document.ErrorRow()), std::max(1, document.ErrorCol())) +
                        ": not valid XML: " + document.ErrorDesc());
    }
    const TiXmlElement* robot = document.FirstChildElement("robot");
    if (robot == nullptr) {
      throw ConfigError(Place(1, 1) + ": expected a <robot> element, found none");
    }
    for (const TiXmlElement* e = robot->FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string_view tag = e->Value();
      if (tag == "link" || tag == "joint") TakeName(*e);
      if (tag == "link" || tag == "joint" || tag == "material") CheckNumbers(*e);
    }
    for (const TiXmlElement* e = robot->FirstChildElement("joint"); e;
         e = e->NextSiblingElement("joint")) {
      CheckJoint(*e);
    }
    UrdfText checked;
    checked.left_out = CheckUrdfElements(*robot, file_);
    CheckUrdfTree(*robot, file_);
    checked.places = std::move(places_);
    return checked;
  }

 private:
  std::string Place(int line, int column) const {
    return file_ + ":" + std::to_string(line) + ":" + std::to_string(column);
  }
  [[noreturn]] void Refuse(const TiXmlElement& at, const std::string& what) const {
    throw ConfigError(Place(at.Row(), at.Column()) + ": <" + at.Value() + ">: " + what);
  }

  /// Keeps the recursive XML parser within its stack and its time.
  void CheckNesting(const std::string& text) const {
    if (const std::optional<XmlFault> fault = ScanXml(text)) {
      throw ConfigError(file_ + ":" + LineAndColumn(text, fault->at) +
                        ": not usable XML: " + fault->what);
    }
  }

  void TakeName(const TiXmlElement& element) {
    const char* name = element.Attribute("name");
    if (name == nullptr || *name == '\0') Refuse(element, "missing attribute 'name'");
    const auto [at, fresh] = places_.emplace(std::string(element.Value()) + " " + name,
                                             Place(element.Row(), element.Column()));
    if (!fresh)
      Refuse(element, std::string("'") + name + "' is given twice, first at " + at->second);
  }

  void CheckNumbers(const TiXmlElement& element) const {
    const bool mass = std::string_view(element.Value()) == "mass";
    if (mass) CheckList(element, "value", 1);
    for (const auto& [name, count] : NumberAttributes()) CheckList(element, name, count);
    for (const TiXmlElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
      CheckNumbers(*e);
    }
  }

  void CheckList(const TiXmlElement& element, const std::string& name, std::size_t count) const {
    const char* attribute = element.Attribute(name.c_str());
    if (attribute == nullptr) return;
    const std::string_view text = attribute;
    std::size_t numbers = 0;
    bool good = true;
    for (std::size_t begin = text.find_first_not_of(" \t\r\n"); begin != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
      double value = 0.0;
      good = good && ParseNumber(text.substr(begin, end - begin), value);
      ++numbers;
      begin = text.find_first_not_of(" \t\r\n", end);
    }
    if (good && numbers == count) return;
    const std::string expected = count == 1 ? "a number" : std::to_string(count) + " numbers";
    Refuse(element,
           name + ": expected " + expected + ", found '" + std::string(text.substr(0, 60)) + "'");
  }

  void CheckJoint(const TiXmlElement& joint) const {
    const char* type = joint.Attribute("type");
    static const std::vector<std::string> types{"continuous", "fixed",     "floating",
                                                "planar",     "prismatic", "revolute"};
    if (type == nullptr || std::find(types.begin(), types.end(), type) == types.end()) {
      Refuse(joint, std::string("type: expected continuous, fixed, floating, planar, prismatic or "
                                "revolute, found '") +
                        (type == nullptr ? "" : type) + "'");
    }
    for (const char* end : {"parent", "child"}) {
      const TiXmlElement* element = joint.FirstChildElement(end);
      const char* link = element == nullptr ? nullptr : element->Attribute("link");
      if (link == nullptr) Refuse(joint, std::string("missing <") + end + " link=\"...\"/>");
      if (places_.count(std::string("link ") + link) == 0) {
        Refuse(*element, std::string("expected the name of a link, found '") + link + "'");
      }
    }
    const bool bounded =
        std::string_view(type) == "revolute" || std::string_view(type) == "prismatic";
    if (bounded && joint.FirstChildElement("limit") == nullptr) Refuse(joint, "missing <limit>");
  }

  std::string file_;
  std::map<std::string, std::string> places_;
};

}  // namespace

UrdfText CheckUrdfXml(const std::string& text, const std::string& file) {
  return XmlCheck(file).Run(text);
}

}  // namespace dockyard
