#include "models/read/collada_check.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <vector>

#include "controller/base/number_text.h"
#include "models/read/collada_parts.h"
#include "models/read/config_error.h"
#include "models/read/xml_scan.h"

namespace dockyard {
namespace {

/// Takes out the children whose names are (or are not) in the list.
void Strip(TiXmlElement& parent, const std::set<std::string>& names, bool listed_stay) {
  for (TiXmlNode* node = parent.FirstChild(); node != nullptr;) {
    TiXmlNode* next = node->NextSibling();
    const bool listed = names.count(node->Value()) > 0;
    if (node->ToComment() != nullptr || (node->ToElement() != nullptr && listed != listed_stay)) {
      parent.RemoveChild(node);
    }
    node = next;
  }
}

/// Elements without a part in a mesh, at every depth: notes, materials, lights, lines.
void StripDeep(TiXmlElement& parent) {
  static const std::set<std::string> no_part{"extra",  "technique",      "bind_material",
                                             "lines",  "linestrips",     "instance_light",
                                             "render", "instance_camera"};
  Strip(parent, no_part, false);
  for (TiXmlElement* e = parent.FirstChildElement(); e; e = e->NextSiblingElement()) StripDeep(*e);
}

/// Numbers of transforms, which an importer reads beyond their end, in all nodes below.
void CheckNodes(const std::string& file, const TiXmlElement& parent) {
  static const std::map<std::string, int> counts{{"lookat", 9}, {"matrix", 16},   {"rotate", 4},
                                                 {"scale", 3},  {"translate", 3}, {"skew", 7}};
  for (const TiXmlElement* e = parent.FirstChildElement(); e; e = e->NextSiblingElement()) {
    const std::string name = e->Value();
    if (name == "instance_controller") RefuseElement(file, *e, "skinned meshes are not read");
    CheckNodes(file, *e);
    const auto count = counts.find(name);
    if (count == counts.end()) continue;
    std::string_view text = TextOf(file, *e);
    int found = 0;
    double value = 0.0;
    for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text)) {
      found += ParseNumber(word, value) ? 1 : 100;
    }
    if (found == count->second) continue;
    RefuseElement(file, *e, "expected " + std::to_string(count->second) + " numbers");
  }
}

/// The length that the file's numbers count. An importer multiplies by any number.
void CheckUnit(const std::string& file, const TiXmlElement& unit) {
  const char* text = unit.Attribute("meter");
  if (text == nullptr) return;  // 1 m
  double metres = 0.0;
  // Smaller ones put all places on one point.
  if (ParseNumber(text, metres) && metres >= 1e-9) return;
  RefuseElement(
      file, unit,
      std::string("meter: expected the metres of a unit, a number from 1e-9 such as 0.001, "
                  "found '") +
          std::string(text).substr(0, 40) + "'");
}

}  // namespace

void RefuseElement(const std::string& file, const TiXmlElement& at, const std::string& what) {
  throw ConfigError(file + ":" + std::to_string(at.Row()) + ":" + std::to_string(at.Column()) +
                    ": not a usable mesh: <" + at.Value() + ">: " + what);
}

std::string_view TextOf(const std::string& file, const TiXmlElement& element) {
  const TiXmlNode* child = element.FirstChild();
  if (child == nullptr) return {};
  if (child->ToText() == nullptr || child->NextSibling() != nullptr) {
    RefuseElement(file, element, "expected text alone");
  }
  return child->Value();
}

std::string_view TakeWord(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

long WholeNumber(std::string_view text) {
  constexpr long kMost = 100000000;
  long value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size() && text[0] != '-';
  return whole && value <= kMost ? value : -1;
}

long CountOf(const std::string& file, const TiXmlElement& element, const char* name,
             long fallback) {
  const char* text = element.Attribute(name);
  if (text == nullptr && fallback >= 0) return fallback;
  const long value = WholeNumber(text == nullptr ? "" : text);
  if (value >= 0) return value;
  RefuseElement(file, element,
                std::string(name) + ": expected a whole number from 0 to 1e8, found '" +
                    std::string(text == nullptr ? "" : text).substr(0, 40) + "'");
}

std::string CheckedCollada(const std::string& text, const std::string& file) {
  if (const std::optional<XmlFault> fault = ScanXml(text)) {
    throw ConfigError(file + ":" + LineAndColumn(text, fault->at) +
                      ": not a usable mesh: " + fault->what);
  }
  TiXmlDocument document;
  document.Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    throw ConfigError(file + ":" + std::to_string(std::max(1, document.ErrorRow())) + ":" +
                      std::to_string(std::max(1, document.ErrorCol())) +
                      ": not a usable mesh: not valid XML: " + document.ErrorDesc());
  }
  TiXmlElement* collada = document.RootElement();
  if (collada == nullptr || std::string_view(collada->Value()) != "COLLADA") {
    throw ConfigError(file + ": not a usable mesh: no Collada document");
  }
  Strip(*collada,
        {"asset", "library_geometries", "library_nodes", "library_visual_scenes", "scene"}, true);
  for (TiXmlElement* e = collada->FirstChildElement("asset"); e;
       e = e->NextSiblingElement("asset")) {
    Strip(*e, {"unit", "up_axis"}, true);
    for (const TiXmlElement* unit = e->FirstChildElement("unit"); unit;
         unit = unit->NextSiblingElement("unit")) {
      CheckUnit(file, *unit);
    }
  }
  StripDeep(*collada);
  for (TiXmlElement* library = collada->FirstChildElement("library_geometries"); library;
       library = library->NextSiblingElement("library_geometries")) {
    Strip(*library, {"geometry"}, true);
    for (TiXmlElement* geometry = library->FirstChildElement(); geometry;
         geometry = geometry->NextSiblingElement()) {
      Strip(*geometry, {"mesh"}, true);
      for (const TiXmlElement* mesh = geometry->FirstChildElement(); mesh;
           mesh = mesh->NextSiblingElement()) {
        CheckColladaMesh(file, *mesh);
      }
    }
  }
  for (const char* library : {"library_nodes", "library_visual_scenes"}) {
    for (const TiXmlElement* e = collada->FirstChildElement(library); e;
         e = e->NextSiblingElement(library)) {
      CheckNodes(file, *e);
    }
  }
  TiXmlPrinter printer;
  printer.SetStreamPrinting();
  collada->Accept(&printer);
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>" + printer.Str();
}

}  // namespace dockyard
