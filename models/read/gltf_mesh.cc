#include "models/read/gltf_mesh.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "models/read/config_error.h"
#include "models/read/gltf_document.h"
#include "models/read/mesh_limits.h"

namespace dockyard {
namespace {

using nlohmann::json;

constexpr long kByte = 5121, kShort = 5123, kInt = 5125, kFloat = 5126;
constexpr long kTriangles = 4, kStrip = 5, kFan = 6;

class GltfReader {
 public:
  explicit GltfReader(GltfDocument document) : document_(std::move(document)) {}

  TriangleMesh Run() {
    if (document_.root().contains("skins")) Refuse("\"skins\", which is not read");
    const json& scene = document_.Item("scenes", Whole(document_.root(), "scene", 0));
    for (const json& node : List(scene, "nodes")) Visit(node, Eigen::Affine3d::Identity());
    if (mesh_.triangles.empty()) Refuse("it has no triangles");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void Refuse(const std::string& why) const { document_.Refuse(why); }
  long Whole(const json& of, const char* key, long fallback = -1) const {
    return document_.Whole(of, key, fallback);
  }
  const json& List(const json& of, const char* key) const { return document_.List(of, key); }

  /// Each node is drawn once: nodes make a tree.
  void Visit(const json& at, const Eigen::Affine3d& parent) {
    if (!at.is_number_unsigned()) Refuse("nodes: expected places in a list");
    if (!visited_.insert(at.get<long>()).second) Refuse("a node with two parents or in a circle");
    const json& node = document_.Item("nodes", at.get<long>());
    const Eigen::Affine3d place = parent * PlaceOf(node);
    if (node.contains("skin")) Refuse("\"skin\", which is not read");
    if (node.contains("mesh")) {
      for (const json& primitive :
           List(document_.Item("meshes", Whole(node, "mesh")), "primitives")) {
        Append(primitive, place);
      }
    }
    for (const json& child : List(node, "children")) Visit(child, place);
  }

  Eigen::Affine3d PlaceOf(const json& node) const {
    const auto numbers = [&](const char* key, std::vector<double> fallback) {
      const json& list = List(node, key);
      if (list.empty()) return fallback;
      if (list.size() != fallback.size()) {
        Refuse(std::string(key) + ": expected " + std::to_string(fallback.size()) + " numbers");
      }
      return list.get<std::vector<double>>();
    };
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    const std::vector<double> matrix =
        numbers("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});  // by columns
    const std::vector<double> t = numbers("translation", {0, 0, 0}),
                              s = numbers("scale", {1, 1, 1}),
                              q = numbers("rotation", {0, 0, 0, 1});
    place.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix.data());
    return place * Eigen::Translation3d(t[0], t[1], t[2]) *
           Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized() *
           Eigen::Scaling(s[0], s[1], s[2]);
  }

  void Append(const json& primitive, const Eigen::Affine3d& place) {
    const long mode = Whole(primitive, "mode", kTriangles);
    if (mode > kFan) Refuse("mode: expected a whole number from 0 to 6");
    if (mode < kTriangles) return;  // points and lines
    if (primitive.contains("targets")) Refuse("\"targets\", which is not read");
    document_.RefuseExtensions(primitive);
    const GltfElements positions = document_.Accessor(
        Whole(primitive.value("attributes", json::object()), "POSITION"), "VEC3", {{kFloat, 4}}, 3);
    std::vector<std::uint32_t> corners(positions.count);
    for (std::size_t i = 0; i < positions.count; ++i) corners[i] = static_cast<std::uint32_t>(i);
    if (primitive.contains("indices")) {
      corners = Indices(document_.Accessor(Whole(primitive, "indices"), "SCALAR",
                                           {{kByte, 1}, {kShort, 2}, {kInt, 4}}, 1));
    }
    if (mode == kTriangles ? corners.size() % 3 != 0 : corners.size() < 3) {
      Refuse("expected three corners a triangle");
    }
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (std::size_t i = 0; i < positions.count; ++i) AppendVertex(positions, i, place);
    const bool mirrored = place.linear().determinant() < 0.0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += mode == kTriangles ? 3 : 1) {
      const bool odd = mode == kStrip && i % 2 == 1;
      std::array<std::uint32_t, 3> triangle{corners[mode == kFan ? 0 : i], corners[i + 1],
                                            corners[i + 2]};
      if (odd != mirrored) std::swap(triangle[1], triangle[2]);
      for (std::uint32_t& corner : triangle) {
        if (corner >= positions.count) Refuse("a vertex index out of range");
        corner += first;
      }
      mesh_.triangles.push_back(triangle);
      if (mesh_.triangles.size() > kMaxMeshTriangles) {
        Refuse("more than " + std::to_string(kMaxMeshTriangles) + " triangles");
      }
    }
  }

  void AppendVertex(const GltfElements& positions, std::size_t at, const Eigen::Affine3d& place) {
    const std::size_t from = at * positions.stride;
    const Eigen::Vector3d p = place * Eigen::Vector3d(NumberAt<float>(positions.bytes, from),
                                                      NumberAt<float>(positions.bytes, from + 4),
                                                      NumberAt<float>(positions.bytes, from + 8));
    if (!(p.cwiseAbs().maxCoeff() <= kMaxMeshCoordinate_m) || p.hasNaN()) {
      Refuse("a coordinate that is not finite or beyond " +
             std::to_string(static_cast<int>(kMaxMeshCoordinate_m)) + " m");
    }
    mesh_.vertices.push_back(p);
    if (mesh_.vertices.size() > 3 * kMaxMeshTriangles) {
      Refuse("more than " + std::to_string(3 * kMaxMeshTriangles) + " vertices");
    }
  }

  static std::vector<std::uint32_t> Indices(const GltfElements& elements) {
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < elements.count; ++i) {
      const std::size_t from = i * elements.stride;
      indices.push_back(elements.component == kByte ? NumberAt<std::uint8_t>(elements.bytes, from)
                        : elements.component == kShort
                            ? NumberAt<std::uint16_t>(elements.bytes, from)
                            : NumberAt<std::uint32_t>(elements.bytes, from));
    }
    return indices;
  }

  GltfDocument document_;
  std::set<long> visited_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh ReadGltf(const std::filesystem::path& file, std::string_view bytes, bool binary) {
  try {
    return GltfReader(GltfDocument(file, bytes, binary)).Run();
  } catch (const nlohmann::json::exception& error) {  // a value of another kind
    throw ConfigError(file.string() + ": not a usable mesh: " + error.what());
  }
}

}  // namespace dockyard
