// A first look at a URDF file's XML, for what liburdfdom tells without line numbers: syntax, names,
// references between links and joints, and every number.
#pragma once

#include <map>
#include <string>

namespace dockyard {

/// Where the links and joints are written: "link NAME" or "joint NAME" -> "file:line:col". Throws
/// ConfigError with line and column for XML that does not parse or nests deeper than 64 levels,
/// names missing or given twice, joints between links that are not there, unknown joint types, and
/// attributes that should be numbers and are not.
std::map<std::string, std::string> CheckUrdfXml(const std::string& text, const std::string& file);

}  // namespace dockyard
