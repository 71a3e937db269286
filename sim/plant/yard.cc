#include "sim/plant/yard.h"

#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "models/read/load_soil.h"
#include "sim/plant/height_file.h"
#include "sim/scenario/patch_keys.h"

namespace dockyard {
namespace {

// Off the target's height: more points to a wrong scale. Assumed, 5-50 m.
constexpr double kMostHeight_m = 20.0;

void CheckHeights(const HeightGrid& ground, const YardHeights& heights) {
  for (std::size_t i = 0; i < ground.heights_m.size(); ++i) {
    const double height_m = ground.heights_m[i];
    if (std::abs(height_m) <= kMostHeight_m) continue;
    const auto nx = static_cast<std::size_t>(ground.nx);
    const std::string where =
        "x = " + NumberText(ground.x0_m + static_cast<double>(i % nx) * ground.cell_m) +
        " m, y = " + NumberText(ground.y0_m + static_cast<double>(i / nx) * ground.cell_m) + " m";
    throw ConfigError(heights.file + ": expected heights all over the yard, within " +
                      NumberText(kMostHeight_m) + " m of the target's, found " +
                      (std::isnan(height_m) ? "none" : NumberText(height_m) + " m") + " at " +
                      where);
  }
}

void MarkSoils(const YardModel& yard, HeightGrid& ground) {
  if (yard.patches.empty()) return;
  const std::vector<std::string> files = PatchSoilFiles(yard);
  ground.soils.assign(ground.heights_m.size(), 0);
  for (const YardPatch& patch : yard.patches) {
    const auto number = std::find(files.begin(), files.end(), patch.soil_file) - files.begin() + 1;
    for (int iy = 0; iy < ground.ny; ++iy) {
      for (int ix = 0; ix < ground.nx; ++ix) {
        const Eigen::Vector2d p(ground.x0_m + ix * ground.cell_m, ground.y0_m + iy * ground.cell_m);
        if (!Holds(patch, p)) continue;
        ground.soils[static_cast<std::size_t>(iy) * ground.nx + ix] =
            static_cast<std::uint8_t>(number);
      }
    }
  }
}

}  // namespace

std::vector<std::string> PatchSoilFiles(const YardModel& yard) {
  std::vector<std::string> files;
  for (const YardPatch& patch : yard.patches) {
    if (std::find(files.begin(), files.end(), patch.soil_file) == files.end()) {
      files.push_back(patch.soil_file);
    }
  }
  return files;
}

std::vector<SoilModel> PatchSoils(const YardModel& yard, double gravity_m_s2, double width_m) {
  std::vector<SoilModel> soils;
  for (const std::string& file : PatchSoilFiles(yard)) {
    soils.push_back(LoadSoil(file));
    CheckCarries(soils.back(), file, width_m);
    if (soils.back().gravity_m_s2 == gravity_m_s2) continue;
    throw ConfigError(file + ": gravity_m_s2: expected " + NumberText(gravity_m_s2) +
                      ", that of the yard's soil, found '" + NumberText(soils.back().gravity_m_s2) +
                      "'");
  }
  return soils;
}

HeightGrid YardGround(const YardModel& yard, double flat_radius_m, const Seed& seed,
                      double behind_m) {
  HeightGrid ground =
      LevelGrid(-behind_m, yard.length_m - kYardBehind_m + behind_m, yard.width_m, yard.cell_m);
  AddUndulation(ground, yard.undulation_rms_m, yard.undulation_wavelength_m, flat_radius_m,
                StreamKey(seed, "yard"));
  MarkSoils(yard, ground);
  if (yard.heights.file.empty()) return ground;
  AddHeights(ground, LoadHeights(yard.heights), flat_radius_m);
  CheckHeights(ground, yard.heights);
  return ground;
}

}  // namespace dockyard
