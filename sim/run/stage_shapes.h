// What a spectator sees of a run's world, without where it is: for reports and pictures from
// outside.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "render/scene.h"

namespace dockyard {

struct StagePart {
  std::shared_ptr<const RenderMesh> mesh;
  Pose3 X_OP;                          // in the body
  Eigen::Vector3d rgb{0.5, 0.5, 0.5};  // linear, 0..1
};

struct StageBody {
  std::string name;    // as in Stage::bodies
  bool robot = false;  // part of the robot, or of its target
  std::vector<StagePart> parts;
};

struct StageBoard {
  std::string body;
  Pose3 X_OB;
  FiducialBoard board;
  Eigen::Vector2d p_BH{0, 0};  // of a round hole
  double hole_radius_m = 0.0;  // 0: none
};

struct StageShapes {
  std::vector<StageBody> bodies;  // in the order of Stage::bodies
  std::optional<StageBoard> board;
  SunAndSky light;
  Eigen::Vector3d ground_rgb{0.5, 0.5, 0.5};  // linear, 0..1
  std::uint64_t ground_texture_seed = 1;
};

}  // namespace dockyard
