// The part of URDF that a rigid model needs: links with mass, visuals and collisions, joints
// between them. Read by liburdfdom and then checked.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "models/parts/link.h"
#include "models/read/mesh_loader.h"

namespace dockyard {

struct UrdfJoint {
  std::string name, parent, child;
  std::string type;  // continuous, revolute, prismatic, fixed, floating, planar
  Pose3 X_PJ;        // joint (and child link) frame in the parent link
  Eigen::Vector3d axis_J{1, 0, 0};
  double lower_rad = 0.0, upper_rad = 0.0;  // revolute only
  std::string place;                        // file:line:col, for messages
};

/// Poses in LinkModel are in the link's own frame.
struct UrdfModel {
  std::string name, file, root;
  std::vector<LinkModel> links;         // by name
  std::vector<UrdfJoint> joints;        // by name
  std::vector<std::string> place;       // of each link, for messages
  std::map<std::string, int> left_out;  // elements that change nothing here -> how many

  /// Throw ConfigError when there is no such link or joint.
  const LinkModel& Link(const std::string& name) const;
  const UrdfJoint& Joint(const std::string& name) const;
  const std::string& PlaceOf(const std::string& link) const;
};

/// Any tree of links and joints. Throws ConfigError: XML that does not parse, elements that are
/// neither read nor without effect, links outside the tree (with line and column), objections of
/// liburdfdom, masses or inertias that no body can have, numbers out of range, meshes that are
/// missing, leave the file's folder or do not load. Links without <inertial> have zero mass.
/// @param meshes  as of LoadMesh
UrdfModel LoadUrdf(const std::string& file, MeshStore* meshes = nullptr);

}  // namespace dockyard
