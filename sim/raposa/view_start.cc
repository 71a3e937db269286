#include "sim/raposa/view_start.h"

#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/images/png.h"
#include "sim/raposa/raposa_plant.h"

namespace dockyard::raposa {
namespace {

/// The guide's middle and the corners of the blue square in the picture; null: outside of its lens.
Json MarksJson(const BuiltRun& built, const Truth& truth) {
  const BackCameraModel& camera = built.world.robot.camera;
  const MarksModel& marks = built.world.pyramid.marks;
  const Pose3 X_CP = Inverse(truth.X_WR * camera.X_RC) * truth.X_WP;
  const auto pixel = [&](const Eigen::Vector3d& p_P) {
    const auto at = camera.camera.Project(X_CP * p_P);
    return at ? dockyard::ToJson(*at) : Json();
  };
  const double half_m = 0.5 * marks.edge_m;
  Json corners = Json::array();
  for (const double y : {half_m, -half_m}) {
    for (const double z : {half_m, -half_m}) {
      corners.push_back(pixel({-marks.behind_m, y, z}));
    }
  }
  return {{"guide_px", pixel(Eigen::Vector3d::Zero())}, {"square_px", corners}};
}

}  // namespace

void WriteStartView(const Scenario& scenario, const RaposaModels& models,
                    const std::filesystem::path& dir) {
  RaposaPlant plant(scenario, BuildRun(scenario, models), std::make_shared<KeptRenderer>());
  const std::vector<CameraImage> images = plant.TakeImages({kBackCamera}, 0.0);
  std::filesystem::create_directories(dir);
  WriteWhole(dir / "back.png", EncodePng(std::get<RgbImage>(images.at(0).pixels)));
  Json json = MarksJson(plant.built(), plant.truth());
  json["range_m"] = plant.truth().range_m;
  json["alpha_rad"] = plant.truth().alpha_rad;
  json["X_PR"] = ToJson(plant.truth().X_PR);
  WriteWhole(dir / "truth.json", json.dump(1) + "\n");
}

}  // namespace dockyard::raposa
