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
#include "sim/plant/drawn_mesh.h"
#include "sim/plant/sun_motion.h"

namespace dockyard {

struct StagePart {
  std::shared_ptr<const RenderMesh> mesh;
  Pose3 X_OP;                          // in the body
  Eigen::Vector3d rgb{0.5, 0.5, 0.5};  // linear, 0..1
  Stains stains{};
};

struct StageBody {
  std::string name;    // as in Stage::bodies
  bool robot = false;  // part of the robot
  std::vector<StagePart> parts;
  bool about = false;   // surroundings: part neither of the robot nor of its target
  bool leaves = false;  // a crown that throws speckled shade
};

/// Adds drawn parts, whose frame L is X_OL in the body.
inline void AddParts(const std::vector<DrawnPart>& parts, const Pose3& X_OL, StageBody& body) {
  for (const DrawnPart& part : parts) {
    body.parts.push_back({part.mesh, X_OL * part.X_LV, part.albedo});
  }
}

/// A point that a spectator may want to see from near.
struct StagePoint {
  std::string name, body;
  Eigen::Vector3d p_O{0, 0, 0};  // in the body
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
  std::vector<StageBoard> boards;
  SunAndSky light;                             // at the run's start; later: sun_motion.h
  std::optional<Eigen::Vector3d> to_pole_W{};  // about which the sun turns; none: it stays
  // The ground as the cameras see it: GroundView has the meanings.
  Eigen::Vector3d ground_rgb{0.5, 0.5, 0.5};  // linear, 0..1
  std::uint64_t ground_texture_seed = 1;
  double ground_grain = 1.0, largest_pebble_m = kAllPebbles_m;
  std::vector<StagePoint> points;  // in addition to the bodies' own origins
};

inline SunAndSky LightAt(const StageShapes& shapes, double seconds) {
  return LightAt(shapes.light, shapes.to_pole_W, seconds);
}

}  // namespace dockyard
