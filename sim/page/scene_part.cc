#include "sim/page/scene_part.h"

#include <Eigen/Geometry>
#include <vector>

namespace dockyard {
namespace {

Json Numbers(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

void PutPose(const Pose3& X, Json& into) {
  const Eigen::Quaterniond q(X.R);
  into["position"] = Numbers(X.p);
  into["quaternion"] = Json::array({q.x(), q.y(), q.z(), q.w()});
}

/// @param body  its place among the bodies
Json BoardJson(const StageBoard& stage, std::size_t body) {
  const FiducialBoard& board = stage.board;
  Json discs = Json::array(), holes = Json::array();
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
  if (stage.hole_radius_m > 0.0) {
    holes.push_back(
        {{"x", stage.p_BH.x()}, {"y", stage.p_BH.y()}, {"radius", stage.hole_radius_m}});
  }
  Json json{{"body", body},
            {"width_m", board.width_m},
            {"height_m", board.height_m},
            {"discs", discs},
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
  std::size_t of_board = 0;
  for (const StageBody& body : shapes.bodies) {
    if (shapes.board && body.name == shapes.board->body) of_board = bodies.size();
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
  if (shapes.board) scene["board"] = BoardJson(*shapes.board, of_board);
  const auto [place, fresh] = scene_places_.emplace(scene.dump(), scenes_.size());
  if (fresh) scenes_.push_back(std::move(scene));
  return place->second;
}

}  // namespace dockyard
