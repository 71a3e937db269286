#include "models/read/mesh_loader.h"

#include <map>
#include <mutex>
#include <string>

#include "models/read/collada_check.h"
#include "models/read/mesh_child.h"
#include "models/read/mesh_format.h"
#include "models/read/mesh_import.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

using SharedMesh = std::shared_ptr<const TriangleMesh>;

/// Meshes read before, by what the importer saw: a process costs 15 ms, and each load of a model
/// reads all its meshes. Only formats that keep everything in one file.
class MeshMemory {
 public:
  SharedMesh Find(const std::string& bytes) {
    const std::lock_guard lock(mutex_);
    const auto known = meshes_.find(bytes);
    return known == meshes_.end() ? nullptr : known->second;
  }
  void Keep(const std::string& bytes, SharedMesh mesh) {
    constexpr std::size_t kMost = 2 * kMaxMeshBytes;  // two of the largest, or some hundred others
    const std::lock_guard lock(mutex_);
    if (kept_bytes_ + bytes.size() > kMost) {
      meshes_.clear();
      kept_bytes_ = 0;
    }
    if (meshes_.emplace(bytes, std::move(mesh)).second) kept_bytes_ += bytes.size();
  }

 private:
  std::mutex mutex_;
  std::map<std::string, SharedMesh> meshes_;
  std::size_t kept_bytes_ = 0;
};

}  // namespace

SharedMesh LoadMesh(const std::filesystem::path& file) {
  if (!IsMeshFile(file)) CheckMeshFormat(file, {});  // throws before the file is touched
  std::string bytes = ReadBytes(file, kMaxMeshBytes);
  const MeshStatement stated = CheckMeshFormat(file, bytes);
  const MeshFormat format = stated.format;
  if (format == MeshFormat::kDae) bytes = CheckedCollada(bytes, file.string());
  static MeshMemory memory;
  const bool whole = format != MeshFormat::kGltf && format != MeshFormat::kGlb;
  const std::string key = std::to_string(static_cast<int>(format)) + bytes;
  SharedMesh mesh = whole ? memory.Find(key) : nullptr;
  if (mesh) return mesh;
  mesh = std::make_shared<const TriangleMesh>(MeshFromChild(
      file.string(), kImportLimits, [&] { return ImportMesh(file, bytes, stated.triangles); }));
  if (whole) memory.Keep(key, mesh);
  return mesh;
}

}  // namespace dockyard
