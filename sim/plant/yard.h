// What the scenario's keys make of the yard.
#pragma once

#include <string>
#include <vector>

#include "models/parts/soil_model.h"
#include "sim/base/random.h"
#include "sim/scenario/scenario.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// The files of the patches' soils, each once, in the order of their numbers: 1, 2 ...
std::vector<std::string> PatchSoilFiles(const YardModel& yard);
/// Those soils, of this gravity, which bear plates of this width. Throws ConfigError.
std::vector<SoilModel> PatchSoils(const YardModel& yard, double gravity_m_s2, double width_m);

/// The ground: undulation and the heights of a file, level within flat_radius_m of the target, with
/// the soils of its patches. It begins behind_m behind the target. Throws ConfigError.
HeightGrid YardGround(const YardModel& yard, double flat_radius_m, const Seed& seed,
                      double behind_m = kYardBehind_m);

}  // namespace dockyard
