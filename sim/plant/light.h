// The three kinds of light of the Mars Yard days, made of sun, sky and occluders (Tsai et al., V-D:
// even or lightly speckled on days 1 and 2, an intense uneven shadow on day 3), and that of a room.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/geometry/pose.h"
#include "render/scene.h"
#include "render/spectrum.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// A thing that cameras see, posed in the world, where it stays.
struct SceneryObject {
  SceneObject object;
  Spectrum reflectance;
};

struct Lighting {
  SunAndSky sun_and_sky;                       // at the run's start; later: sun_motion.h
  std::optional<Eigen::Vector3d> to_pole_W{};  // about which the sun turns; none: it stays
  std::vector<SceneObject> occluders;          // posed in the world; they stay where they are
  std::vector<SceneryObject> scenery{};
  bool leaves = false;                 // whether those are leaves
  double board_dust = 0.0;             // mean share of the board's face under dust
  std::vector<DustySpot> dusty_spots;  // of the board, dirtier than the rest
};

/// Scenery and occluders at the end of a scene's objects.
void AddSurroundings(const Lighting& lighting, std::vector<SceneObject>& objects);

/// @param X_WD   the dock's ground frame in the world, z off the ground: the board faces along its
///               +x. The sun's elevation is above the level, on a slope too.
/// @param p_DB   the board's centre in it [m]
/// @param seed   of the run; sun's place and the occluders' detail vary with it
/// @param sun    the scenario's values; its azimuth counts from +x of D, counter-clockwise. With an
///               opacity the irradiances follow from it and the sun's height, not from the kind
Lighting MakeLighting(Light light, const Pose3& X_WD, const Eigen::Vector3d& p_DB, const Seed& seed,
                      const SunModel& sun = {});

}  // namespace dockyard
