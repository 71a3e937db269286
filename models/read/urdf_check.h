// A first check of a URDF file's XML, for faults that liburdfdom reports without line numbers:
// syntax, names, references between links and joints, elements nobody reads, and every number.
#pragma once

#include <map>
#include <string>

namespace dockyard {

struct UrdfText {
  std::map<std::string, std::string> places;  // "link NAME" or "joint NAME" -> "file:line:col"
  std::map<std::string, int> left_out;        // elements that change nothing here -> how many
};

/// Throws ConfigError with line and column for XML that does not parse or that ScanXml refuses,
/// names missing or given twice, joints between links that are not there, unknown joint types,
/// attributes that should be numbers and are not, and all that CheckUrdfElements and CheckUrdfTree
/// refuse.
UrdfText CheckUrdfXml(const std::string& text, const std::string& file);

}  // namespace dockyard
