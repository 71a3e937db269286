// Links and joints as liburdfdom gives them, in our structs, checked number by number.
#pragma once

#include <tinyxml.h>
#include <urdf_model/model.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "models/read/mesh_address.h"
#include "models/read/urdf.h"
#include "models/read/urdf_faults.h"

namespace dockyard {

/// Reads the parts of one file; counts what all of them have together, and keeps its meshes. Faults
/// name the element that has them.
class UrdfParts {
 public:
  UrdfParts(const std::string& file, const UrdfOptions& options, UrdfFaults& faults);

  /// @param element  the same link in the file
  LinkModel ReadLink(const urdf::Link& in, const TiXmlElement& element);
  UrdfJoint ReadJoint(const urdf::Joint& in, const TiXmlElement& element) const;
  std::vector<std::string> TakeWarnings() { return std::move(warnings_); }

 private:
  using Mesh = std::shared_ptr<const TriangleMesh>;

  void ReadInertial(const urdf::Inertial& in, const TiXmlElement& element, const std::string& place,
                    LinkModel& link);
  Visual ReadVisual(const urdf::Visual& in, const std::string& place);
  /// A mesh with hollows becomes several.
  void ReadCollision(const urdf::Collision& in, const std::string& place,
                     std::vector<Collision>& collisions);
  void AddHulls(const Collision& collision, const urdf::Mesh& named, const std::string& place,
                std::vector<Collision>& collisions);
  Mesh ReadMesh(const urdf::Geometry& geometry, const std::string& place);
  void Spend(std::size_t corners, const std::string& place);

  UrdfFaults& faults_;
  MeshAddresses addresses_;
  MeshStore* store_;
  std::size_t parts_left_ = 2000, corners_left_ = 6 * kMaxMeshTriangles;
  std::map<std::string, Mesh> meshes_;                                       // by path
  std::map<std::string, std::vector<std::vector<Eigen::Vector3d>>> pieces_;  // by name and scale
  std::vector<std::string> warnings_;
};

}  // namespace dockyard
