#include "sim/custom/view_start.h"

#include <numeric>

#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/custom/custom_plant.h"
#include "sim/images/png.h"

namespace dockyard::custom {

void WriteStartView(const Scenario& scenario, const CustomModels& models,
                    const std::filesystem::path& dir) {
  CustomPlant plant(scenario, BuildRun(scenario, models), std::make_shared<KeptRenderer>());
  const std::vector<RobotCamera>& cameras = plant.built().nominal.cameras;
  std::vector<int> all(cameras.size());
  std::iota(all.begin(), all.end(), 0);
  std::filesystem::create_directories(dir);
  for (const CameraImage& image : plant.TakeImages(all, 0.0)) {
    const std::string png =
        std::visit([](const auto& pixels) { return EncodePng(pixels); }, image.pixels);
    WriteWhole(dir / (cameras[static_cast<std::size_t>(image.camera)].name + ".png"), png);
  }
  using dockyard::ToJson;
  Json json;
  json["X_DR"] = ToJson(plant.truth().X_DR);
  json["X_QP"] = ToJson(plant.truth().X_QP);
  WriteWhole(dir / "truth.json", json.dump(1) + "\n");
}

}  // namespace dockyard::custom
