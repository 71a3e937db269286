// The scene to draw: posed meshes, boards, ground, cables, sun, sky and lamps. It contains no
// physics. Lengths in metres, colours linear 0..1, light in arbitrary radiance units.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/pose.h"

namespace dockyard {

struct RenderMesh {
  std::vector<Eigen::Vector3f> vertices;                // in the object's frame
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
};

/// Stains on an object, as minerals have them: noise in three dimensions, so that it has no seams.
/// It belongs to the object's frame and moves with it.
struct Stains {
  // Standard deviation of the albedo over its mean, before a pixel's footprint averages it; 0:
  // none. Rocks: assumed, 0.1-0.2.
  double contrast = 0.0;
  std::uint64_t seed = 1;
  double largest_m = 0.016, least_m = 0.002;  // sizes of the stains; assumed, 8-30 and 1-4 mm
};

/// Meshes keep their GPU copies as long as the same shared_ptr is passed again.
struct SceneObject {
  std::shared_ptr<const RenderMesh> mesh;
  Pose3 X_WO;
  Eigen::Vector3d albedo{0.5, 0.5, 0.5};
  int material = 0;  // of a ColourTable, whose cameras do not ask for the albedo
  bool seen = true;  // false: its shadow alone is, as that of the body round a camera
  Stains stains{};
};

/// No pebble of the texture is as large.
inline constexpr double kAllPebbles_m = 1.0;

/// Row-major heights over the site frame G: height(ix, iy) at x0 + ix * cell, y0 + iy * cell.
struct GroundView {
  Pose3 X_WG;
  double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0;
  int nx = 0, ny = 0;
  const double* heights_m = nullptr;  // [iy * nx + ix]
  std::uint64_t revision = 0;         // changes when heights change
  Eigen::Vector3d albedo{0.45, 0.36, 0.28};
  std::uint64_t texture_seed = 1;
  double grain = 1.0;  // contrast of grain, pebbles and lumps, 0 to 1; 0: a plain floor
  int material = 0;    // see SceneObject
  // Longer half side of the largest pebble that is painted on the ground; larger ones are left out,
  // so that a scene may have them as objects. The paint has no height for a stereo pair to see.
  double largest_pebble_m = kAllPebbles_m;
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
  // Mean share of the ink that has flaked off in patches of 1 to 4 mm, 0 to 0.95, and where.
  double wear = 0.0;
  std::uint64_t wear_seed = 1;
  // A plate that is bent about a cylinder (bent_plate.h): how far its middle is out to its
  // viewer over its edges, below zero a hollow, to a tenth of the plate; and the direction in which
  // it bends, as a bar's rotation.
  double flatness_m = 0.0, bow_rad = 0.0;
};

struct TetherView {
  std::vector<Eigen::Vector3d> points_W;  // polyline, arm tip first
  double diameter_m = 0.0;
  Eigen::Vector3d albedo{0.6, 0.5, 0.1};
  int material = 0;  // see SceneObject
};

/// Stray light of a lens, of scattering and of reflections between its surfaces
/// (render/stray_light.h); none by default.
struct StrayLight {
  double veil = 0.0;               // share of the light that is scattered
  double core_rad = Radians(0.5);  // width of the scattered light's core, see stray_light.h
  double ghosts = 0.0;             // share of the sun's light in ghosts

  bool none() const { return veil == 0.0 && ghosts == 0.0; }
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
  // Optical depth of the air, for light that follows the sun's height; NaN: it does not.
  double opacity = std::numeric_limits<double>::quiet_NaN();
  StrayLight stray{};  // of every lens in this light
};

/// A lamp without an extent. It throws no shadows: those of a lamp at the camera would be hidden
/// behind what throws them. Its light counts as white for grey cameras.
struct Lamp {
  Eigen::Vector3d p_W{0, 0, 0}, axis_W{0, 0, 1};  // axis: unit, the way it shines
  // Off the axis to where the intensity has fallen to one half: it goes as a power of the cosine,
  // as data sheets of light diodes have it (60 deg: a flat diode without a lens). 0: equal on all
  // sides.
  double half_angle_rad = 0.0;
  double irradiance_1m = 0.0;  // on the axis, on a surface 1 m away that faces the lamp
  int kind = 0;                // which of a ColourTable's lamps
};

/// What the images are about: the shadows are finest here, and views are denser.
struct Interest {
  Eigen::Vector3d p_W{0, 0, 0};
  double radius_m = 0.0;
};

struct Scene {
  std::vector<SceneObject> objects;  // robot, target, occluders; all cast shadows
  GroundView ground;
  TetherView tether;
  SunAndSky light;
  std::vector<BoardView> boards{};
  std::vector<TetherView> cables{};  // further ones
  std::vector<Lamp> lamps{};
  std::optional<Interest> interest{};  // none: the board that fills most of the image, if any
};

/// Tether and cables together.
std::vector<const TetherView*> ThinBodies(const Scene& scene);

}  // namespace dockyard
