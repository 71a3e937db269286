// A first check of a URDF file's XML, for faults that liburdfdom reports without line numbers:
// syntax, names, references between links and joints, elements nobody reads, and every number.
#pragma once

#include <tinyxml.h>

#include <map>
#include <memory>
#include <string>

#include "models/read/urdf_faults.h"

namespace dockyard {

/// Throws ConfigError with line and column for XML that does not parse, that ScanXml refuses, or
/// that has no <robot>.
std::unique_ptr<TiXmlDocument> ParseUrdfXml(const std::string& text, const std::string& name);

/// How many elements are left out, by name; they are gone from `robot` afterwards. Faults are names
/// missing or given twice, joints between links that are not there, unknown joint types, attributes
/// that should be numbers and are not, and all that CheckUrdfElements and CheckUrdfTree find.
std::map<std::string, int> CheckUrdfXml(TiXmlElement& robot, UrdfFaults& faults);

}  // namespace dockyard
