// A URDF file with the joints' keys of a YAML file -> LinkTree.
#pragma once

#include "models/parts/link_tree.h"
#include "models/read/load_joints.h"
#include "models/read/urdf.h"

namespace dockyard {

/// Any tree. in: the YAML file, for messages. Throws ConfigError as TakeJointedLinks, and for a
/// root without mass.
LinkTree TakeLinkTree(const YamlReader& in, const UrdfModel& urdf, const JointsFile& file);

/// The frame of a link by its name. Throws ConfigError whose message begins with `place`.
const NamedFrame& RequireFrame(const LinkTree& tree, const std::string& name,
                               const std::string& place);

}  // namespace dockyard
