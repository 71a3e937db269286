// Triangle meshes from files: STL, OBJ, Collada (DAE) and glTF (gltf, glb) through assimp, but for
// the plainest OBJ files (plain_obj.h). Mesh importers are known for crashing on malformed input,
// so assimp is restricted: only these formats, magic bytes checked first, sizes capped, nothing
// read from outside the file's folder, a process of its own with limits (mesh_child.h), and the
// outcome checked number by number.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "models/parts/mesh.h"
#include "models/read/mesh_limits.h"

namespace dockyard {

/// Meshes read before, by what the importer saw: a process of its own costs 15 ms, and each load of
/// a model reads all its meshes. Only of formats that keep everything in one file. For one thread.
class MeshStore {
 public:
  /// None if there is no such mesh.
  std::shared_ptr<const TriangleMesh> Find(const std::string& bytes) const;
  void Keep(const std::string& bytes, std::shared_ptr<const TriangleMesh> mesh);

 private:
  std::map<std::string, std::shared_ptr<const TriangleMesh>> meshes_;
  std::size_t kept_bytes_ = 0;
};

/// All triangles of the file in its root frame, axes as the numbers are written (Collada's up_axis
/// is not followed, glTF is not turned), lengths in metres. Throws ConfigError with one sentence
/// when the file is no mesh of an allowed format, is too large, has no triangle, an index out of
/// range, or a coordinate that is not finite or beyond kMaxMeshCoordinate_m.
/// @param store  may be null: then every call imports the file
std::shared_ptr<const TriangleMesh> LoadMesh(const std::filesystem::path& file,
                                             MeshStore* store = nullptr);

/// Whether the file's extension is one of the allowed ones (.stl .obj .dae .gltf .glb).
bool IsMeshFile(const std::filesystem::path& file);

/// Scales the vertices; mirrored scales (negative product) turn the triangles round.
TriangleMesh Scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale);

/// Primitive bodies for files that have no mesh; cylinder along z. Faces outwards.
TriangleMesh BoxMesh(const Eigen::Vector3d& size_m);
TriangleMesh CylinderMesh(double radius_m, double length_m, int sides = 32);
TriangleMesh SphereMesh(double radius_m, int rings = 16);

}  // namespace dockyard
