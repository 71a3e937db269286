#include "sim/rocky7/view_start.h"

#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/images/png.h"
#include "sim/rocky7/rocky7_plant.h"

namespace dockyard::rocky7 {

void WriteStartView(const Scenario& scenario, const Rocky7Models& models,
                    const std::filesystem::path& dir) {
  Rocky7Plant plant(scenario, BuildRun(scenario, models), std::make_shared<KeptRenderer>());
  const bool by_mast = plant.built().world.boulder.has_value();
  const int left = by_mast ? kMastLeft : kFrontLeft, right = by_mast ? kMastRight : kFrontRight;
  const std::vector<CameraImage> images = plant.TakeImages({left, right}, 0.0);
  std::filesystem::create_directories(dir);
  for (const CameraImage& image : images) {
    WriteWhole(dir / (image.camera == left ? "left.png" : "right.png"),
               EncodePng(std::get<GrayImage>(image.pixels)));
  }
  using dockyard::ToJson;
  Json json;
  json["click_px"] = ToJson(plant.built().nominal.target_px);
  json["X_GR"] = ToJson(plant.truth().X_GR);
  json["point_off_m"] = plant.truth().p_GP.head<2>().norm();
  WriteWhole(dir / "truth.json", json.dump(1) + "\n");
}

}  // namespace dockyard::rocky7
