// The shapes of a run's world in a report.
#pragma once

#include <map>
#include <string>

#include "sim/page/payload.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// `meshes` and `scenes` of the header. Runs with the same shapes share them.
class Scenes {
 public:
  explicit Scenes(Payload& payload) : payload_(payload) {}

  /// The place of the scene in the list.
  std::size_t Add(const StageShapes& shapes);

  const Json& meshes() const { return meshes_; }
  const Json& scenes() const { return scenes_; }

 private:
  std::size_t AddMesh(const RenderMesh& mesh);

  Payload& payload_;
  std::map<std::string, std::size_t> mesh_places_, scene_places_;  // by their bytes
  Json meshes_ = Json::array(), scenes_ = Json::array();
};

}  // namespace dockyard
