// A start of RAPOSA, its picture, and where the marks truly are in it.
#pragma once

#include <cmath>
#include <string>

#include "controller/raposa/marks.h"
#include "models/read/yaml_tree.h"
#include "sim/raposa/raposa_plant.h"
#include "support/source_tree.h"

namespace dockyard::raposa {

/// On a ground, the camera looking at the guide. `keys` and `changes` are in YAML: {a: 1, ...}
/// without the brackets, the keys under `raposa` and those under `changes`.
inline Scenario ScenarioAt(double r_m, double alpha_rad, const std::string& keys = {},
                           const std::string& changes = {}, std::uint64_t seed = 1,
                           const std::string& ground = "hard_floor") {
  const std::string models = SourceFile("models/raposa/");
  Scenario scenario;
  scenario.robot_file = models + "raposa.yaml";
  scenario.soil_file = models + "grounds/" + ground + ".yaml";
  scenario.of_system = ParseYaml(
      "{pyramid: " + models + "pyramid/pyramid.yaml" + (keys.empty() ? "" : ", " + keys) + "}",
      "test");
  if (!changes.empty()) scenario.changes = ParseYaml("{" + changes + "}", "test");
  scenario.start = {r_m, alpha_rad, alpha_rad};
  scenario.yard.undulation_rms_m = 0.0;
  scenario.seed = seed;
  return scenario;
}

struct Picture {
  RgbImage image;
  Nominal nominal;
  Eigen::Vector2d guide_px{0.0, 0.0};
  // Of the blue square by projection: of its side towards the camera alone, where the camera is
  // behind the square.
  double c_px = 0.0, g_px = 0.0;
  bool whole = false;  // square and guide's middle in the view
};

inline Picture PictureOf(const Scenario& scenario, const std::shared_ptr<KeptRenderer>& renderer) {
  RaposaPlant plant(scenario, BuildRun(scenario, LoadModels(scenario)), renderer);
  const BackCameraModel& camera = plant.built().world.robot.camera;
  const MarksModel& marks = plant.built().world.pyramid.marks;
  const Pose3 X_CP = Inverse(plant.truth().X_WR * camera.X_RC) * plant.truth().X_WP;
  const double half_m = 0.5 * marks.edge_m;
  const double reach_px =
      std::get<BrownPinhole>(camera.camera.lens).fx * std::tan(camera.half_view_rad);
  const Eigen::Vector2d middle(0.5 * (camera.camera.width - 1), 0.5 * (camera.camera.height - 1));
  Picture picture;
  picture.nominal = plant.built().nominal;
  picture.whole = true;
  const Eigen::Vector2d guide = *camera.camera.Project(X_CP * Eigen::Vector3d::Zero());
  double top = 1e9, bottom = -1e9;
  picture.guide_px = guide;
  const Eigen::Vector3d p_PC = -(X_CP.R.transpose() * X_CP.p);
  for (const double y : {-half_m, half_m}) {
    if (p_PC.x() < -marks.behind_m && y * p_PC.y() < 0.0) continue;
    for (const double z : {-half_m, half_m}) {
      const Eigen::Vector2d at =
          *camera.camera.Project(X_CP * Eigen::Vector3d(-marks.behind_m, y, z));
      picture.c_px = std::max(picture.c_px, std::abs(at.x() - guide.x()));
      top = std::min(top, at.y());
      bottom = std::max(bottom, at.y());
      if ((at - middle).norm() > reach_px) picture.whole = false;
    }
  }
  picture.g_px = bottom - top;
  if ((guide - middle).norm() > reach_px) picture.whole = false;
  picture.image = std::get<RgbImage>(plant.TakeImages({kBackCamera}, 0.0).at(0).pixels);
  return picture;
}

struct MarksFound {
  bool pair = false, g_right = false, c_right = false;  // within 10 % of the truth
  bool right() const { return g_right && c_right; }
};

inline MarksFound FindIn(const Picture& picture, const HsvBand& orange, const HsvBand& blue) {
  FerreiraVision vision = picture.nominal.ferreira_vision;
  vision.orange = orange;
  vision.blue = blue;
  const MarksSeen seen =
      FindMarks(ColourSearch(picture.image), picture.nominal, vision, std::nullopt);
  if (!seen.pair) return {};
  return {true, std::abs(seen.pair->g_px / picture.g_px - 1.0) <= 0.1,
          std::abs(seen.pair->c_px / picture.c_px - 1.0) <= 0.1};
}

}  // namespace dockyard::raposa
