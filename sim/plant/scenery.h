// Scenery as the cameras see it.
#pragma once

#include <optional>
#include <vector>

#include "render/scene.h"
#include "render/spectrum.h"
#include "sim/base/random.h"
#include "sim/plant/light.h"
#include "sim/scenario/scenario.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// A closed solid turned about z of the frame A from (z, radius), lowest z first. Its outline is
/// within 0.5 % of round.
RenderMesh TurnedMesh(const std::vector<Eigen::Vector2d>& profile_m, const Pose3& X_OA);
/// Of a solid, in the item's frame.
RenderMesh SolidMesh(SceneryItem::Kind kind, const Eigen::Vector3d& size_m);
Spectrum ReflectanceOf(SceneryItem::Colour colour);

/// The solids of a set, each from numbers of its own, however many there are; fewer where there is
/// no room. stream: of the set alone.
std::vector<SceneryItem> DrawSet(const SceneryItem& set, const Eigen::Vector2d& start_D,
                                 std::uint64_t stream);

/// Puts items into the light's surroundings. X_WG: the site; X_GD: the target in it.
void AddItems(const std::vector<SceneryItem>& items, const HeightGrid& ground, const Pose3& X_WG,
              const Pose2& X_GD, Lighting& lighting);
/// The same of the scenario's scenery, with its sets drawn. Throws ConfigError for a file that is
/// no mesh.
void AddScenery(const Scenario& scenario, const HeightGrid& ground, const Pose3& X_WG,
                const Pose2& X_GD, Lighting& lighting);

}  // namespace dockyard
