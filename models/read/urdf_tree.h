// Whether the links and joints of a URDF file make one tree.
#pragma once

#include <tinyxml.h>

#include <string>

namespace dockyard {

/// Throws ConfigError with line and column for a link that is the child of two joints, a link that
/// the tree does not reach (of several trees the largest counts, the first of equals), joints in a
/// circle, and more than 1000 links. Names must have been checked before.
void CheckUrdfTree(const TiXmlElement& robot, const std::string& file);

}  // namespace dockyard
