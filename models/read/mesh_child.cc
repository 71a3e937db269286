#include "models/read/mesh_child.h"

#include <cmath>
#include <cstring>
#include <string_view>
#include <system_error>

#include "models/read/config_error.h"
#include "models/read/mesh_limits.h"

namespace dockyard {
namespace {

// The answer's first byte.
constexpr char kMesh = 'M', kRefused = 'R';
constexpr std::size_t kHeader = 2 * sizeof(std::uint32_t);
constexpr std::size_t kVertexBytes = 3 * sizeof(double);
constexpr std::size_t kTriangleBytes = 3 * sizeof(std::uint32_t);

[[noreturn]] void Refuse(const std::string& file, const std::string& why) {
  throw ConfigError(file + ": not a usable mesh: " + why);
}

template <class T>
T Take(std::string_view& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

}  // namespace

std::string EncodeMesh(const TriangleMesh& mesh) {
  std::string bytes;
  bytes.reserve(kHeader + kVertexBytes * mesh.vertices.size() +
                kTriangleBytes * mesh.triangles.size());
  const auto put = [&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  };
  for (const std::size_t count : {mesh.vertices.size(), mesh.triangles.size()}) {
    const auto number = static_cast<std::uint32_t>(count);
    put(&number, sizeof number);
  }
  for (const Eigen::Vector3d& v : mesh.vertices) put(v.data(), kVertexBytes);
  for (const auto& triangle : mesh.triangles) put(triangle.data(), kTriangleBytes);
  return bytes;
}

TriangleMesh DecodeMesh(const std::string& bytes, const std::string& file) {
  std::string_view rest = bytes;
  if (rest.size() < kHeader) Refuse(file, "the mesh importer sent no mesh");
  const auto vertices = Take<std::uint32_t>(rest), triangles = Take<std::uint32_t>(rest);
  if (triangles == 0 || triangles > kMaxMeshTriangles || vertices > 3 * kMaxMeshTriangles) {
    Refuse(file, "the mesh importer sent " + std::to_string(vertices) + " vertices and " +
                     std::to_string(triangles) + " triangles");
  }
  if (rest.size() != kVertexBytes * vertices + kTriangleBytes * triangles) {
    Refuse(file, "the mesh importer sent a mesh of another length than its counts say");
  }
  TriangleMesh mesh;
  mesh.vertices.resize(vertices);
  mesh.triangles.resize(triangles);
  for (Eigen::Vector3d& v : mesh.vertices) {
    for (double& x : v) {
      x = Take<double>(rest);
      if (!(std::abs(x) <= kMaxMeshCoordinate_m)) {
        Refuse(file, "the mesh importer sent a coordinate that is not finite or too large");
      }
    }
  }
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& index : triangle) {
      index = Take<std::uint32_t>(rest);
      if (index >= vertices) Refuse(file, "the mesh importer sent a vertex index out of range");
    }
  }
  return mesh;
}

TriangleMesh MeshFromChild(const std::string& file, const WorkLimits& limits,
                           const std::function<TriangleMesh()>& import) {
  WorkResult result;
  try {
    result = RunGuarded(limits, [&]() -> std::string {
      try {
        return kMesh + EncodeMesh(import());
      } catch (const ConfigError& error) {
        return kRefused + std::string(error.what());
      }
    });
  } catch (const std::system_error& error) {
    Refuse(file, std::string("the mesh importer ") + error.what());
  }
  if (!result.failure.empty()) Refuse(file, "the mesh importer " + result.failure);
  const char kind = result.answer.empty() ? '\0' : result.answer[0];
  if (kind == kRefused) throw ConfigError(result.answer.substr(1));
  if (kind != kMesh) Refuse(file, "the mesh importer sent no mesh");
  return DecodeMesh(result.answer.substr(1), file);
}

}  // namespace dockyard
