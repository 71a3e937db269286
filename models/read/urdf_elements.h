// The elements and attributes of URDF: some are read, some are left out because they change nothing
// here, and some are refused because they would. The table of docs/reference/models.md.
#pragma once

#include <tinyxml.h>

#include <map>
#include <string>

#include "models/read/urdf_faults.h"

namespace dockyard {

/// How often each element occurs that is left out: "transmission" -> 2; "axis rpy" is an attribute.
/// These are gone from `robot` afterwards. Faults are an element or attribute that is neither read
/// nor left out, one given twice that may occur once, a required one missing, a material with
/// no colour or two, and values that would change what is simulated or drawn: axes with a rotation,
/// a colour that is not opaque or out of range.
std::map<std::string, int> CheckUrdfElements(TiXmlElement& robot, UrdfFaults& faults);

}  // namespace dockyard
