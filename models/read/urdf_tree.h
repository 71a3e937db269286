// Whether the links and joints of a URDF file make one tree.
#pragma once

#include <tinyxml.h>

#include "models/read/urdf_faults.h"

namespace dockyard {

/// Faults are a link that is the child of two joints, a link that the tree does not reach (of
/// several trees the largest counts, the first of equals), joints in a circle, and more than 1000
/// links. Names and the ends of joints must have no fault.
void CheckUrdfTree(const TiXmlElement& robot, UrdfFaults& faults);

}  // namespace dockyard
