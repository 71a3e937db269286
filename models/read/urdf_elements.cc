#include "models/read/urdf_elements.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "controller/base/number_text.h"
#include "models/read/near_names.h"
#include "models/read/urdf_numbers.h"
#include "models/read/urdf_rules.h"

namespace dockyard {
namespace {

bool Contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

class ElementCheck {
 public:
  explicit ElementCheck(UrdfFaults& faults) : faults_(faults) {}

  void Visit(TiXmlElement& element) {
    const std::string name = element.Value();
    const UrdfRule& rule = RuleOfUrdf(name);
    CheckAttributes(element, rule);
    std::set<std::string> found;
    for (TiXmlElement *e = element.FirstChildElement(), *next = nullptr; e; e = next) {
      next = e->NextSiblingElement();
      const std::string child = e->Value();
      if (IsLeftOutOfUrdf(name, *e)) {
        ++left_out_[child];
        element.RemoveChild(e);
        continue;
      }
      const bool once = Contains(rule.once, child);
      if (!once && !Contains(rule.any, child)) {
        AddChild(*e, name, rule);
      } else if (once && !found.insert(child).second) {
        faults_.Add(*e, "given twice in one <" + name + ">");
      } else {
        Visit(*e);
        if (!IsLeftOutOfUrdf(name, *e)) continue;  // a material is empty without its texture
        ++left_out_[child];
        element.RemoveChild(e);
      }
    }
    CheckWhole(element, rule, found);
    if (!faults_.In(element)) CheckValues(element, name);
    if (name == "material") TakeMaterial(element);
  }

  /// Materials of the robot hold for all links, wherever they stand.
  void TakeMaterials(const TiXmlElement& robot) {
    for (const TiXmlElement* e = robot.FirstChildElement("material"); e;
         e = e->NextSiblingElement("material")) {
      const char *name = e->Attribute("name"), *rgba = ColourOf(*e);
      if (name != nullptr && rgba != nullptr) colours_.emplace(name, NumbersOf(rgba));
    }
  }

  std::map<std::string, int> TakeLeftOut() { return std::move(left_out_); }

 private:
  using Colour = std::optional<std::vector<double>>;

  void CheckWhole(const TiXmlElement& element, const UrdfRule& rule,
                  const std::set<std::string>& found) const {
    for (const std::string& needed : rule.must) {
      if (found.count(needed) == 0) faults_.Add(element, "missing <" + needed + ">");
    }
    if (element.ValueStr() == "geometry" && found.size() != 1 && !faults_.In(element)) {
      faults_.Add(element, "expected one shape, found " + std::to_string(found.size()));
    }
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

  void AddChild(const TiXmlElement& child, const std::string& parent, const UrdfRule& rule) const {
    const std::string reason = ReasonAgainstInUrdf(child.Value());
    std::vector<std::string> known = rule.any;
    known.insert(known.end(), rule.once.begin(), rule.once.end());
    faults_.Add(child, reason.empty() ? Unknown("element", child.Value(), parent, known) : reason);
  }

  void CheckAttributes(const TiXmlElement& element, const UrdfRule& rule) {
    const std::string tag = element.Value();
    for (const TiXmlAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
      const std::string name = a->Name();
      if (Contains(rule.attributes, name) || name.rfind("xmlns", 0) == 0) continue;
      if (IsLeftOutAttribute(tag, name) || (tag == "axis" && name == "rpy")) {
        ++left_out_[tag + " " + name];
        continue;
      }
      faults_.Add(element, name + ": " + Unknown("attribute", name, tag, rule.attributes));
    }
  }

  void CheckValues(const TiXmlElement& element, const std::string& name) const {
    if (name == "color") CheckColour(element);
    if (name == "axis" && element.Attribute("rpy") != nullptr) {
      // The format before URDF 1.0 turned the axis by it.
      const auto rpy = NumbersOf(element.Attribute("rpy"));
      if (rpy == std::vector{0.0, 0.0, 0.0}) return;
      faults_.Add(element, std::string("rpy: expected 0 0 0, an axis is turned by its xyz alone; "
                                       "found '") +
                               element.Attribute("rpy") + "'");
    }
  }

  void CheckColour(const TiXmlElement& element) const {
    const Colour rgba = NumbersOf(element.Attribute("rgba"));
    if (!rgba || rgba->size() != 4 || (*rgba)[3] != 1.0) {
      faults_.Add(element, "rgba: expected a last number of 1, nothing is drawn transparent");
      return;
    }
    const auto out =
        std::find_if(rgba->begin(), rgba->end(), [](double x) { return x < 0.0 || x > 1.0; });
    if (out == rgba->end()) return;
    faults_.Add(element,
                "rgba: colour: expected numbers from 0 to 1, found '" + NumberText(*out) + "'");
  }

  static const char* ColourOf(const TiXmlElement& material) {
    const TiXmlElement* color = material.FirstChildElement("color");
    return color == nullptr ? nullptr : color->Attribute("rgba");
  }

  /// One name is one colour: a parser takes the first for all.
  void TakeMaterial(const TiXmlElement& material) {
    const std::string name = material.Attribute("name") ? material.Attribute("name") : "";
    if (faults_.In(material)) return;
    if (ColourOf(material) == nullptr) {
      if (name.empty() || colours_.count(name) > 0) return;
      faults_.Add(material,
                  "expected a <color>, or the name of a material before, found '" + name + "'");
      return;
    }
    const Colour rgba = NumbersOf(ColourOf(material));
    if (name.empty() || colours_.emplace(name, rgba).first->second == rgba) return;
    faults_.Add(material, "'" + name + "' has another colour before");
  }

  UrdfFaults& faults_;
  std::map<std::string, Colour> colours_;  // by material
  std::map<std::string, int> left_out_;
};

}  // namespace

std::map<std::string, int> CheckUrdfElements(TiXmlElement& robot, UrdfFaults& faults) {
  ElementCheck check(faults);
  check.TakeMaterials(robot);
  check.Visit(robot);
  return check.TakeLeftOut();
}

}  // namespace dockyard
