// The scene to draw: posed meshes, board, ground, tether, sun and sky. It contains no physics.
// Lengths in metres, colours linear 0..1, light in arbitrary radiance units.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/pose.h"

namespace dockyard {

struct RenderMesh {
  std::vector<Eigen::Vector3f> vertices;                // in the object's frame
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
};

/// Meshes keep their GPU copies as long as the same shared_ptr is passed again.
struct SceneObject {
  std::shared_ptr<const RenderMesh> mesh;
  Pose3 X_WO;
  Eigen::Vector3d albedo{0.5, 0.5, 0.5};
};

/// Row-major heights over the site frame G: height(ix, iy) at x0 + ix * cell, y0 + iy * cell.
struct GroundView {
  Pose3 X_WG;
  double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0;
  int nx = 0, ny = 0;
  const double* heights_m = nullptr;  // [iy * nx + ix]
  std::uint64_t revision = 0;         // changes when heights change
  Eigen::Vector3d albedo{0.45, 0.36, 0.28};
  std::uint64_t texture_seed = 1;
};

/// A round part of the board that is dustier than the rest.
struct DustySpot {
  Eigen::Vector2d p_B{0, 0};
  double radius_m = 0.0;
  double cover = 0.0;  // mean share covered, 0 to 0.95
};

struct BoardView {
  FiducialBoard board;
  Pose3 X_WB;
  Eigen::Vector2d p_BH{0, 0};  // centre of a round hole in the plate; it may reach over its edge
  double hole_radius_m = 0.0;  // 0: no hole
  double white_albedo = 0.85, black_albedo = 0.05;  // assumed: matt paint, 0.75-0.9 and 0.03-0.08
  // Dust on its face: mean share covered, 0 to 0.6, where it lies, its albedo (that of the soil).
  double dust_cover = 0.0;
  std::vector<DustySpot> dusty_spots;
  std::uint64_t dust_seed = 1;
  Eigen::Vector3d dust_albedo{0.45, 0.36, 0.28};
};

struct TetherView {
  std::vector<Eigen::Vector3d> points_W;  // polyline, arm tip first
  double diameter_m = 0.0;
  Eigen::Vector3d albedo{0.6, 0.5, 0.1};
};

struct SunAndSky {
  Eigen::Vector3d to_sun_W{0, 0, 1};  // unit
  double sun_irradiance = 1.0;        // on a surface facing it
  double sun_angular_diameter_rad = 0.0093;
  double sky_irradiance = 0.25;  // on a level surface, from the whole sky
  double ground_bounce_albedo = 0.3;
  // Colour of either as linear red, green, blue; Luminance of each is 1, so that it does not change
  // grey images.
  Eigen::Vector3d sun_rgb{1, 1, 1}, sky_rgb{1, 1, 1};
};

struct Scene {
  std::vector<SceneObject> objects;  // rover, station, occluders; all cast shadows
  GroundView ground;
  BoardView board;
  TetherView tether;
  SunAndSky light;
};

}  // namespace dockyard
