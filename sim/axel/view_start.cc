#include "sim/axel/view_start.h"

#include <array>
#include <nlohmann/json.hpp>

#include "sim/axel/axel_view.h"
#include "sim/axel/build_run.h"
#include "sim/axel/fiducial_truth.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/images/png.h"
#include "sim/plant/built_cameras.h"
#include "sim/plant/renderer.h"
#include "sim/run/camera_faults.h"

namespace dockyard::axel {
namespace {

Json FiducialsJson(const Scene& scene, const Camera& camera, const Pose3& X_WC,
                   const LensRipple& ripple) {
  Json list = Json::array();
  const auto fiducials = TrueFiducials(scene, camera, X_WC, ripple);
  for (std::size_t id = 0; id < fiducials.size(); ++id) {
    const FiducialPixels& truth = fiducials[id];
    list.push_back({{"id", id},
                    {"centre_px", truth.centre ? ToJson(*truth.centre) : Json()},
                    {"centroid_px", truth.centroid ? ToJson(*truth.centroid) : Json()},
                    {"whole", truth.whole},
                    {"hidden", truth.hidden}});
  }
  return list;
}

void WriteImages(const Scene& scene, const BuiltRun& built, const Pose3& X_WR,
                 const SensorOptions& sensor, bool colour, const std::filesystem::path& out_dir) {
  const StereoRig& rig = built.built_rig;
  const std::unique_ptr<StereoRenderer> renderer = MakeRenderer();
  const bool with_depth = sensor.focus.distance_m > 0.0;
  const auto radiance = renderer->RenderRadiance(scene, rig, X_WR, with_depth, built.ripples);
  const StereoImages images = ExposeStereo(radiance, rig, sensor);
  // A camera that gives no picture leaves no file, not even one of an earlier view.
  const auto write = [&](std::size_t view, const char* file, const auto& image) {
    if (sensor.eyes[view] == EyeState::kSilent) {
      std::filesystem::remove(out_dir / file);
    } else {
      WriteWhole(out_dir / file, EncodePng(image));
    }
  };
  write(0, "left.png", images.left);
  write(1, "right.png", images.right);
  if (sensor.bits > 8) {
    const auto deep = ExposeDeep(radiance, rig, sensor);
    write(0, "left_deep.png", deep[0]);
    write(1, "right_deep.png", deep[1]);
  }
  if (!colour) return;
  const auto rgb = ExposeColour(renderer->RenderColour(scene, rig, X_WR, with_depth, built.ripples),
                                rig, sensor);
  write(0, "left_colour.png", rgb[0]);
  write(1, "right_colour.png", rgb[1]);
}

}  // namespace

void WriteStartView(const Scenario& scenario, const AxelModels& models,
                    const std::filesystem::path& out_dir) {
  const BuiltRun built = BuildRun(scenario, models);
  const World world(built.world);
  const Truth truth = world.truth();
  CheckStart(built, truth);
  MakeFolder(out_dir);
  SceneBuilder builder(built.world.rover, built.world.station, built.world.soil, built.lighting,
                       SiteOf(scenario), scenario.seed);
  builder.AddRocks(built.world.rocks);
  const Scene scene = builder.Make(truth, world.ground());
  WriteImages(scene, built, truth.X_WR,
              WithFaults(CameraSensor(built.world.rover.stereo, scenario.seed, 0),
                         scenario.camera_faults, scenario.seed),
              scenario.colour, out_dir);

  const Pose3 X_RB = Inverse(truth.X_WR) * scene.boards[0].X_WB;
  Json view;
  view["scenario"] = scenario.name;
  view["seed"] = scenario.seed.number;
  view["X_RB"] = ToJson(X_RB);
  view["X_DR"] = ToJson(truth.X_DR);
  view["left"] = FiducialsJson(scene, built.built_rig.left, truth.X_WR * built.built_rig.X_RL,
                               built.ripples[0]);
  view["right"] = FiducialsJson(scene, built.built_rig.right, truth.X_WR * built.built_rig.X_RQ,
                                built.ripples[1]);
  WriteWhole(out_dir / "view.json", view.dump(2) + "\n");
}

}  // namespace dockyard::axel
