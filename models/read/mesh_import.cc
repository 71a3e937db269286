#include "models/read/mesh_import.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/BaseImporter.h>
#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <exception>
#include <set>

#include "models/read/config_error.h"
#include "models/read/gltf_mesh.h"
#include "models/read/mesh_limits.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

/// A file held in memory.
class MemoryStream : public Assimp::IOStream {
 public:
  explicit MemoryStream(std::string bytes) : bytes_(std::move(bytes)) {}
  std::size_t Read(void* out, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
    std::memcpy(out, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t base = origin == aiOrigin_SET   ? 0
                             : origin == aiOrigin_CUR ? at_
                                                      : bytes_.size();
    const std::size_t target = base + offset;  // a negative offset wraps round and back
    if (target > bytes_.size()) return aiReturn_FAILURE;
    at_ = target;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return at_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

/// The only file open to an importer: the mesh itself.
class OneFile : public Assimp::IOSystem {
 public:
  OneFile(std::string file, std::string bytes) : file_(std::move(file)), bytes_(std::move(bytes)) {}
  bool Exists(const char* name) const override { return file_ == name; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    const bool reads = std::strpbrk(mode, "wa") == nullptr;
    return reads && Exists(name) ? new MemoryStream(bytes_) : nullptr;
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string file_, bytes_;
};

/// Leaves the importer with the allowed formats only, so that no other parser sees the bytes.
void KeepAllowedFormats(Assimp::Importer& importer) {
  const std::set<std::string> allowed{"stl", "obj", "dae"};
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    std::set<std::string> extensions;
    importer.GetImporter(i)->GetExtensionList(extensions);
    const bool keep = std::any_of(extensions.begin(), extensions.end(),
                                  [&](const std::string& e) { return allowed.count(e) > 0; });
    if (!keep) others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* other : others) {
    importer.UnregisterLoader(other);
    delete other;
  }
}

class Collector {
 public:
  Collector(const aiScene& scene, std::string file) : scene_(scene), file_(std::move(file)) {}

  TriangleMesh Take() {
    Visit(scene_.mRootNode, aiMatrix4x4(), 0);
    if (mesh_.triangles.empty()) Refuse("it has no triangles");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void Refuse(const std::string& why) const {
    throw ConfigError(file_ + ": not a usable mesh: " + why);
  }

  void Visit(const aiNode* node, const aiMatrix4x4& parent, int depth) {
    if (node == nullptr) return;
    if (depth > 64) Refuse("its nodes are nested too deep");
    const aiMatrix4x4 place = parent * node->mTransformation;
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      if (node->mMeshes[i] >= scene_.mNumMeshes) Refuse("a node names a mesh that is not there");
      Append(*scene_.mMeshes[node->mMeshes[i]], place);
    }
    for (unsigned i = 0; i < node->mNumChildren; ++i) Visit(node->mChildren[i], place, depth + 1);
  }

  void Append(const aiMesh& part, const aiMatrix4x4& place) {
    if (part.mNumFaces > kMaxMeshTriangles - mesh_.triangles.size() ||
        part.mNumVertices > 3 * kMaxMeshTriangles - mesh_.vertices.size()) {
      Refuse("more than " + std::to_string(kMaxMeshTriangles) + " triangles");
    }
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    const bool mirrored = place.Determinant() < 0;
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D v = place * part.mVertices[i];
      for (const double x : {v.x, v.y, v.z}) {
        if (!(std::abs(x) <= kMaxMeshCoordinate_m)) {
          Refuse("a coordinate that is not finite or beyond " +
                 std::to_string(static_cast<int>(kMaxMeshCoordinate_m)) + " m");
        }
      }
      mesh_.vertices.emplace_back(v.x, v.y, v.z);
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines
      std::array<std::uint32_t, 3> triangle{};
      for (unsigned k = 0; k < 3; ++k) {
        if (face.mIndices[k] >= part.mNumVertices) Refuse("a vertex index out of range");
        triangle[k] = first + face.mIndices[k];
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      mesh_.triangles.push_back(triangle);
    }
  }

  const aiScene& scene_;
  std::string file_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh ImportMesh(const fs::path& file, const MeshStatement& stated) {
  const bool binary = stated.format == MeshFormat::kGlb;
  if (binary || stated.format == MeshFormat::kGltf) return ReadGltf(file, stated.bytes, binary);
  try {
    Assimp::Importer importer;
    KeepAllowedFormats(importer);
    // Numbers as written: a link frame is z up, whatever up axis the file states.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetIOHandler(new OneFile(file.string(), stated.bytes));
    const aiScene* scene =
        importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr) {
      std::string reason = importer.GetErrorString();
      std::replace(reason.begin(), reason.end(), '\n', ' ');
      throw ConfigError(file.string() + ": not a usable mesh: " +
                        (reason.empty() ? "it cannot be read" : reason.substr(0, 200)));
    }
    // First as it is: the step that joins vertices drops those that are not numbers.
    Collector(*scene, file.string()).Take();
    scene = importer.ApplyPostProcessing(aiProcess_JoinIdenticalVertices);
    return Collector(*scene, file.string()).Take();
  } catch (const ConfigError&) {
    throw;
  } catch (const std::exception& error) {
    throw ConfigError(file.string() + ": not a usable mesh: " + error.what());
  }
}

}  // namespace dockyard
