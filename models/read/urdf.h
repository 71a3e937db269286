// The part of URDF that a rigid model needs: links with mass, visuals and collisions, joints
// between them. Read by liburdfdom and then checked.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "models/parts/link.h"
#include "models/read/mesh_address.h"
#include "models/read/mesh_loader.h"

namespace dockyard {

struct UrdfJoint {
  std::string name, parent, child;
  std::string type;  // continuous, revolute, prismatic, fixed, floating, planar
  Pose3 X_PJ;        // joint (and child link) frame in the parent link
  Eigen::Vector3d axis_J{1, 0, 0};
  double lower_rad = 0.0, upper_rad = 0.0;  // of a revolute joint; of a prismatic one [m]
  double damping_nms_per_rad = 0.0, friction_nm = 0.0;  // of a prismatic joint [N s/m, N]
  std::string mimics;                                   // another joint; empty: it moves by itself
  double mimic_ratio = 1.0, mimic_offset_rad = 0.0;     // of its angle
  std::string place;                                    // file:line:col, for messages
};

/// Poses in LinkModel are in the link's own frame.
struct UrdfModel {
  std::string name, file, root;
  std::vector<LinkModel> links;         // by name
  std::vector<UrdfJoint> joints;        // by name
  std::vector<std::string> place;       // of each link, for messages
  std::map<std::string, int> left_out;  // elements that change nothing here -> how many
  std::vector<std::string> warnings;    // each with its place

  /// Throw ConfigError when there is no such link or joint.
  const LinkModel& Link(const std::string& name) const;
  const UrdfJoint& Joint(const std::string& name) const;
  const std::string& PlaceOf(const std::string& link) const;
};

struct UrdfOptions {
  MeshStore* meshes = nullptr;  // as of LoadMesh
  PackageFolders packages = {};
  bool expand_xacro = false;  // run the program xacro on a file with macros
};

/// Any tree of links and joints. Throws ConfigError: XML that does not parse, elements that are
/// neither read nor without effect, links outside the tree (with line and column), objections of
/// liburdfdom, masses or inertias that no body can have, numbers out of range, meshes that are
/// missing, leave the file's folder or package (MeshAddresses) or do not load, macros of xacro that
/// are not to be expanded. Links without <inertial>, or with a mass of 0 and moments of 0, have
/// zero mass.
UrdfModel LoadUrdf(const std::string& file, const UrdfOptions& options);
UrdfModel LoadUrdf(const std::string& file, MeshStore* meshes = nullptr);

/// Everything that LoadUrdf would object to, in the order of the file: each link, joint, visual and
/// collision is read by itself. Faults that follow from another are not among them: a part with a
/// number that is none is not weighed, a tree with a joint to nowhere is not searched for its root.
struct UrdfFindings {
  std::vector<std::string> faults;
  std::map<std::string, int> left_out;  // as of UrdfModel
};
UrdfFindings FindUrdfFaults(const std::string& file, const UrdfOptions& options);

}  // namespace dockyard
