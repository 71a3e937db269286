// A body of links as a URDF file has it: its root, all that hangs on joints, and every named frame.
#pragma once

#include <string>
#include <vector>

#include "models/parts/jointed_link.h"
#include "models/parts/link.h"

namespace dockyard {

/// A link of the URDF file as a frame F. Links on fixed joints are part of the link that carries
/// them.
struct NamedFrame {
  std::string name;
  int link = 0;  // 0: the root; from 1 on JointedLinks::links
  Pose3 X_LF;
};

struct LinkTree {
  LinkModel root;
  JointedLinks joints;
  std::vector<NamedFrame> frames;

  int link_count() const { return 1 + static_cast<int>(joints.links.size()); }
  const LinkModel& link(int i) const {
    return i == 0 ? root : joints.links[static_cast<std::size_t>(i - 1)].link;
  }
  /// The joint that carries a link other than the root.
  const JointedLink& joint(int link) const {
    return joints.links[static_cast<std::size_t>(link - 1)];
  }
  double mass_kg() const { return root.mass_kg + joints.mass_kg(); }
  /// The frame of that name; null: there is none.
  const NamedFrame* Frame(const std::string& name) const {
    for (const NamedFrame& frame : frames) {
      if (frame.name == name) return &frame;
    }
    return nullptr;
  }
  /// The number of the link that a joint carries; -1: there is no such joint, or it is fixed.
  int LinkOfJoint(const std::string& joint) const {
    for (std::size_t i = 0; i < joints.links.size(); ++i) {
      if (joints.links[i].joint == joint) return static_cast<int>(i) + 1;
    }
    return -1;
  }
};

/// Masses and moments of all links.
void ScaleMass(double scale, LinkTree& tree);

/// Of every link in the root's frame R, with each joint at its start.
std::vector<Pose3> StartPoses(const LinkTree& tree);

}  // namespace dockyard
