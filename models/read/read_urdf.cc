#include "models/read/urdf.h"

#include <utility>

#include "models/read/config_error.h"
#include "models/read/text_file.h"
#include "models/read/urdf_check.h"
#include "models/read/urdf_parts.h"
#include "models/read/urdf_text.h"
#include "models/read/xacro.h"

namespace dockyard {
namespace {

struct Source {
  std::string name;  // as messages begin
  std::string text;
  std::unique_ptr<TiXmlDocument> document;
};

/// The file as it is, or expanded by xacro.
Source ReadSource(const std::string& file, bool expand_xacro) {
  Source source{file, "", nullptr};
  std::string place;
  if (IsXacroFile(file)) {
    place = file + ": its name says that it holds macros: ";
  } else {
    source.text = ReadText(file);
    source.document = ParseUrdfXml(source.text, file);
    const auto macro = FindMacro(*source.document->FirstChildElement("robot"));
    if (!macro) return source;
    place = file + ":" + macro->place + ": '" + macro->text + "' is a macro or an argument: ";
  }
  if (!expand_xacro) {
    ReadText(file);
    throw ConfigError(place + "only `check` expands it; " + HowToExpand(file));
  }
  source.name = file + " (expanded)";
  source.text = ExpandXacro(file, place);
  source.document = ParseUrdfXml(source.text, source.name);
  if (const auto left = FindMacro(*source.document->FirstChildElement("robot"))) {
    throw ConfigError(source.name + ":" + left->place + ": xacro has left '" + left->text +
                      "' as it was");
  }
  return source;
}

using ElementsByName = std::map<std::string, const TiXmlElement*>;

ElementsByName Named(const TiXmlElement& robot, const char* tag) {
  ElementsByName named;
  for (const TiXmlElement* e = robot.FirstChildElement(tag); e; e = e->NextSiblingElement(tag)) {
    if (const char* name = e->Attribute("name")) named.emplace(name, e);
  }
  return named;
}

/// A robot of this element and of empty links.
std::string Alone(const TiXmlElement& element, const std::vector<std::string>& links) {
  TiXmlElement robot("robot");
  robot.SetAttribute("name", "alone");
  for (const std::string& name : links) {
    TiXmlElement link("link");
    link.SetAttribute("name", name);
    robot.InsertEndChild(link);
  }
  robot.InsertEndChild(element);
  return TextOfXml(robot);
}

/// Reads the parts of one file one by one, each in a robot of its own.
class PartByPart {
 public:
  PartByPart(UrdfParts& parts, UrdfFaults& faults) : parts_(parts), faults_(faults) {}

  void ReadLink(const TiXmlElement& link) {
    const char* name = link.Attribute("name");
    if (name == nullptr || *name == '\0') return;
    for (const TiXmlElement* e = link.FirstChildElement(); e; e = e->NextSiblingElement()) {
      if (faults_.In(*e)) continue;
      TiXmlElement holder("link");
      holder.SetAttribute("name", name);
      TiXmlElement* part = holder.InsertEndChild(*e)->ToElement();
      // Its colour has been checked, and may be defined in another link.
      if (TiXmlElement* material = part->FirstChildElement("material")) part->RemoveChild(material);
      faults_.Catch(*e, [&] {
        const auto parsed = ParseUrdfText(Alone(holder, {}), faults_.PlaceOf(*e));
        parts_.ReadLink(*parsed->links_.at(name), holder);
      });
    }
  }

  void ReadJoint(const TiXmlElement& joint) {
    if (faults_.In(joint)) return;
    const std::string parent = joint.FirstChildElement("parent")->Attribute("link");
    const std::string child = joint.FirstChildElement("child")->Attribute("link");
    if (parent == child) return;  // a fault of the tree
    faults_.Catch(joint, [&] {
      const auto parsed = ParseUrdfText(Alone(joint, {parent, child}), faults_.PlaceOf(joint));
      parts_.ReadJoint(*parsed->joints_.at(joint.Attribute("name")), joint);
    });
  }

 private:
  UrdfParts& parts_;
  UrdfFaults& faults_;
};

void ReadPartByPart(const TiXmlElement& robot, UrdfParts& parts, UrdfFaults& faults) {
  PartByPart part_by_part(parts, faults);
  for (const TiXmlElement* e = robot.FirstChildElement("link"); e;
       e = e->NextSiblingElement("link")) {
    part_by_part.ReadLink(*e);
  }
  for (const TiXmlElement* e = robot.FirstChildElement("joint"); e;
       e = e->NextSiblingElement("joint")) {
    part_by_part.ReadJoint(*e);
  }
}

}  // namespace

UrdfModel LoadUrdf(const std::string& file, MeshStore* meshes) {
  return LoadUrdf(file, UrdfOptions{.meshes = meshes});
}

UrdfModel LoadUrdf(const std::string& file, const UrdfOptions& options) {
  const Source source = ReadSource(file, options.expand_xacro);
  TiXmlElement& robot = *source.document->FirstChildElement("robot");
  UrdfFaults faults(source.name, UrdfFaults::Wanted::kFirst);
  UrdfModel model;
  model.left_out = CheckUrdfXml(robot, faults);
  UrdfParts parts(file, options, faults);
  urdf::ModelInterfaceSharedPtr parsed;
  try {
    // liburdfdom takes the first element of a <geometry> for its shape, whatever it is.
    parsed = ParseUrdfText(model.left_out.empty() ? source.text : TextOfXml(robot), source.name);
  } catch (const ConfigError&) {
    ReadPartByPart(robot, parts, faults);  // says where, which liburdfdom does not
    throw;
  }
  model.name = parsed->getName();
  model.file = file;
  model.root = parsed->getRoot() ? parsed->getRoot()->name : "";
  const ElementsByName links = Named(robot, "link"), joints = Named(robot, "joint");
  for (const auto& [name, link] : parsed->links_) {
    const TiXmlElement& element = *links.at(name);
    model.place.push_back(faults.PlaceOf(element) + ": link '" + name + "'");
    model.links.push_back(parts.ReadLink(*link, element));
  }
  for (const auto& [name, joint] : parsed->joints_) {
    model.joints.push_back(parts.ReadJoint(*joint, *joints.at(name)));
  }
  model.warnings = parts.TakeWarnings();
  return model;
}

UrdfFindings FindUrdfFaults(const std::string& file, const UrdfOptions& options) {
  UrdfFindings found;
  try {
    const Source source = ReadSource(file, options.expand_xacro);
    TiXmlElement& robot = *source.document->FirstChildElement("robot");
    UrdfFaults faults(source.name, UrdfFaults::Wanted::kAll);
    found.left_out = CheckUrdfXml(robot, faults);
    UrdfParts parts(file, options, faults);
    ReadPartByPart(robot, parts, faults);
    found.faults = faults.Sorted();
    if (found.faults.empty()) LoadUrdf(file, options);  // the totals over all parts
  } catch (const ConfigError& error) {
    found.faults = {error.what()};
  }
  return found;
}

}  // namespace dockyard
