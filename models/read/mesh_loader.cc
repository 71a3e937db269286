#include "models/read/mesh_loader.h"

#include <optional>
#include <string>

#include "models/read/mesh_child.h"
#include "models/read/mesh_format.h"
#include "models/read/mesh_import.h"
#include "models/read/plain_obj.h"
#include "models/read/text_file.h"

namespace dockyard {

std::shared_ptr<const TriangleMesh> MeshStore::Find(const std::string& bytes) const {
  const auto known = meshes_.find(bytes);
  return known == meshes_.end() ? nullptr : known->second;
}

void MeshStore::Keep(const std::string& bytes, std::shared_ptr<const TriangleMesh> mesh) {
  constexpr std::size_t kMost = 2 * kMaxMeshBytes;  // two of the largest, or some hundred others
  if (kept_bytes_ + bytes.size() > kMost) {
    meshes_.clear();
    kept_bytes_ = 0;
  }
  if (meshes_.emplace(bytes, std::move(mesh)).second) kept_bytes_ += bytes.size();
}

std::shared_ptr<const TriangleMesh> LoadMesh(const std::filesystem::path& file, MeshStore* store) {
  if (!IsMeshFile(file)) CheckMeshFormat(file, {});  // throws before the file is touched
  const MeshStatement stated = CheckMeshFormat(file, ReadBytes(file, kMaxMeshBytes));
  const MeshFormat format = stated.format;
  const bool whole = format != MeshFormat::kGltf && format != MeshFormat::kGlb;
  const std::string key = std::to_string(static_cast<int>(format)) + stated.bytes;
  if (!whole) store = nullptr;
  if (store != nullptr) {
    if (auto known = store->Find(key)) return known;
  }
  std::optional<TriangleMesh> plain;
  if (format == MeshFormat::kObj) plain = PlainObj(stated.bytes);
  const auto import = [&] { return ImportMesh(file, stated); };
  const auto mesh = std::make_shared<const TriangleMesh>(
      plain ? std::move(*plain) : MeshFromChild(file.string(), kImportLimits, import));
  if (store != nullptr) store->Keep(key, mesh);
  return mesh;
}

}  // namespace dockyard
