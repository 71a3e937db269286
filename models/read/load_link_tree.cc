#include "models/read/load_link_tree.h"

#include "models/read/config_error.h"
#include "models/read/near_names.h"
#include "models/read/urdf_weld.h"

namespace dockyard {

LinkTree TakeLinkTree(const YamlReader& in, const UrdfModel& urdf, const JointsFile& file) {
  const UrdfModel welded = WeldFixedLinks(urdf);
  LinkTree tree;
  tree.root = RequireInertial(welded, urdf.root);
  tree.joints = TakeJointedLinks(in, welded, {{urdf.root}, {}}, file);
  for (const LinkModel& link : urdf.links) {
    const std::string carrier = CarrierOf(urdf, link.name);
    NamedFrame frame{link.name, -1, FrameInCarrier(urdf, link.name)};
    for (int i = 0; i < tree.link_count(); ++i) {
      if (tree.link(i).name == carrier) frame.link = i;
    }
    tree.frames.push_back(frame);
  }
  return tree;
}

const NamedFrame& RequireFrame(const LinkTree& tree, const std::string& name,
                               const std::string& place) {
  const NamedFrame* frame = tree.Frame(name);
  if (frame != nullptr) return *frame;
  std::vector<std::string> known;
  for (const NamedFrame& each : tree.frames) known.push_back(each.name);
  throw ConfigError(place + ": expected a link of the URDF file, found '" + name + "'" +
                    DidYouMeanOrKnown(name, known));
}

}  // namespace dockyard
