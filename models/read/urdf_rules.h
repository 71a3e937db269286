// Which elements and attributes of URDF are read, left out or refused.
#pragma once

#include <tinyxml.h>

#include <string>
#include <vector>

namespace dockyard {

/// The allowed content of an element. `once` holds the children that may not be repeated, `must`
/// those of them that may not be missing.
struct UrdfRule {
  std::vector<std::string> attributes, once, any, must = {};
};

/// The element must be one that is read.
const UrdfRule& RuleOfUrdf(const std::string& element);
/// Whether such an element changes nothing here: a note for another program, or an empty one.
bool IsLeftOutOfUrdf(const std::string& parent, const TiXmlElement& element);
bool IsLeftOutAttribute(const std::string& element, const std::string& attribute);
/// Why a known element of URDF is refused; empty for any other.
std::string ReasonAgainstInUrdf(const std::string& name);

}  // namespace dockyard
