// The rocks of a run's yard, from its scenario.
#pragma once

#include "render/scene.h"
#include "sim/axel/load_models.h"
#include "sim/axel/rock_bed.h"
#include "sim/scenario/scenario.h"
#include "sim/soil/height_grid.h"

namespace dockyard::axel {

/// Whether there is any in the yard, under a wheel too.
bool HasRocks(const Scenario& scenario, const AxelModels& models);

/// Each stands in the ground at the height that the ground has below its middle. None when the
/// scenario has none. Throws ConfigError for a rock of a given place under the station, for a clear
/// radius within which station or arm reach, and for more rocks than can be kept.
RockBed BuildRocks(const Scenario& scenario, const AxelModels& models, const HeightGrid& ground);

/// Linear red, green and blue of the rocks in a yard of this soil, 0..1.
Eigen::Vector3d RockAlbedo(const SoilModel& soil);

/// All in one, three corners to each triangle, in their order, so that no faces share a normal; in
/// G.
RenderMesh RockMesh(const RockBed& bed);

}  // namespace dockyard::axel
