#include "sim/page/scene_part.h"

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

namespace dockyard {
namespace {

Json Numbers(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

void PutPose(const Pose3& X, Json& into) {
  const Eigen::Quaterniond q(X.R);
  into["position"] = Numbers(X.p);
  into["quaternion"] = Json::array({q.x(), q.y(), q.z(), q.w()});
}

Json TagJson(const SquareTag& tag) {
  std::string black;
  for (const std::uint8_t cell : tag.cells.black) black += cell != 0 ? '1' : '0';
  return {{"x", tag.p_BT.x()},    {"y", tag.p_BT.y()},          {"turn", tag.rotation},
          {"cell", tag.cell_m()}, {"across", tag.cells.across}, {"black", black}};
}

/// @param body  its place among the bodies
Json BoardJson(const StageBoard& stage, std::size_t body) {
  const FiducialBoard& board = stage.board;
  Json discs = Json::array(), tags = Json::array(), holes = Json::array();
  for (const Fiducial& fiducial : board.fiducials) {
    Json bar;
    if (board.HasBars()) {
      bar = {{"length", board.bar_length_m},
             {"width", board.bar_width_m},
             {"turn", fiducial.rotation}};
    }
    discs.push_back({{"x", fiducial.p_BF.x()},
                     {"y", fiducial.p_BF.y()},
                     {"radius", 0.5 * board.disc_diameter_m},
                     {"bar", bar}});
  }
  for (const SquareTag& tag : board.tags) tags.push_back(TagJson(tag));
  if (stage.hole_radius_m > 0.0) {
    holes.push_back(
        {{"x", stage.p_BH.x()}, {"y", stage.p_BH.y()}, {"radius", stage.hole_radius_m}});
  }
  Json json{{"body", body},
            {"width_m", board.width_m},
            {"height_m", board.height_m},
            {"discs", discs},
            {"tags", tags},
            {"holes", holes}};
  PutPose(stage.X_OB, json);
  return json;
}

}  // namespace

std::size_t Scenes::AddMesh(const RenderMesh& mesh) {
  std::vector<float> vertices;
  for (const Eigen::Vector3f& v : mesh.vertices)
    vertices.insert(vertices.end(), v.begin(), v.end());
  std::vector<std::uint32_t> triangles;
  for (const auto& triangle : mesh.triangles) {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  std::string bytes(reinterpret_cast<const char*>(vertices.data()),
                    vertices.size() * sizeof(float));
  bytes.append(reinterpret_cast<const char*>(triangles.data()),
               triangles.size() * sizeof(std::uint32_t));
  const auto [place, fresh] = mesh_places_.emplace(std::move(bytes), meshes_.size());
  if (fresh) {
    meshes_.push_back({{"vertices", payload_.AddNumbers(vertices)},
                       {"triangles", payload_.AddNumbers(triangles)}});
  }
  return place->second;
}

std::size_t Scenes::Add(const StageShapes& shapes) {
  Json bodies = Json::array();
  std::map<std::string, std::size_t> places;
  for (const StageBody& body : shapes.bodies) {
    places[body.name] = bodies.size();
    Json parts = Json::array();
    for (const StagePart& part : body.parts) {
      Json json{{"mesh", AddMesh(*part.mesh)}, {"colour", Numbers(part.rgb)}};
      PutPose(part.X_OP, json);
      parts.push_back(json);
    }
    Json json{{"name", body.name}, {"robot", body.robot}, {"parts", parts}};
    if (body.about) json["about"] = true;
    if (body.leaves) json["leaves"] = true;
    bodies.push_back(std::move(json));
  }
  Json scene{{"bodies", bodies},
             {"sun_W", Numbers(shapes.light.to_sun_W)},
             {"ground", Numbers(shapes.ground_rgb)}};
  for (const StageBoard& board : shapes.boards) {
    scene["boards"].push_back(BoardJson(board, places.at(board.body)));
  }
  const auto [place, fresh] = scene_places_.emplace(scene.dump(), scenes_.size());
  if (fresh) scenes_.push_back(std::move(scene));
  return place->second;
}

}  // namespace dockyard
