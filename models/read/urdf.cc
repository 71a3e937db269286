#include "models/read/urdf.h"

#include "models/read/config_error.h"

namespace dockyard {

const LinkModel& UrdfModel::Link(const std::string& link_name) const {
  for (const LinkModel& link : links) {
    if (link.name == link_name) return link;
  }
  throw ConfigError(file + ": expected a link named '" + link_name + "', found none");
}

const std::string& UrdfModel::PlaceOf(const std::string& link_name) const {
  return place[static_cast<std::size_t>(&Link(link_name) - links.data())];
}

const UrdfJoint& UrdfModel::Joint(const std::string& joint_name) const {
  for (const UrdfJoint& joint : joints) {
    if (joint.name == joint_name) return joint;
  }
  throw ConfigError(file + ": expected a joint named '" + joint_name + "', found none");
}

}  // namespace dockyard
