#include "raposa/sim/eye_pictures.h"

#include <cmath>

#include "models/read/yaml_tree.h"
#include "sim/raposa/raposa_plant.h"

namespace dockyard::raposa {

TakenPicture TakePictureOf(const PictureSetup& setup,
                           const std::shared_ptr<KeptRenderer>& renderer) {
  const std::string models = std::string(DOCKYARD_SOURCE_DIR) + "/models/raposa/";
  Scenario scenario;
  scenario.robot_file = models + "raposa.yaml";
  scenario.soil_file = models + "grounds/" + setup.ground + ".yaml";
  scenario.of_system = ParseYaml(
      "{pyramid: " + models + "pyramid/pyramid.yaml, light_k: " + std::to_string(setup.light_k) +
          ", balance_k: " + std::to_string(setup.balance_k) + "}",
      "test");
  scenario.start = {setup.r_m, setup.alpha_rad, setup.alpha_rad + setup.beside_rad};
  scenario.yard.undulation_rms_m = setup.undulation_rms_m;
  scenario.seed = setup.seed;
  scenario.light = setup.light == "even"       ? Light::kEven
                   : setup.light == "speckled" ? Light::kSpeckled
                                               : Light::kHardShadow;
  RaposaPlant plant(scenario, BuildRun(scenario, LoadModels(scenario)), renderer);
  if (setup.lamps) {
    Commands commands = BrakedCommands();
    commands.switches[kLamps] = 1;
    plant.Advance(commands);
    plant.RefreshTruth();
  }
  TakenPicture taken;
  taken.nominal = plant.built().nominal;
  const Pose3 X_WC = plant.truth().X_WR * plant.built().world.robot.camera.X_RC;
  const Eigen::Vector3d view = X_WC.R.col(2);
  const Pose2 X_WV{X_WC.p.x(), X_WC.p.y(), std::atan2(view.y(), view.x())};
  taken.X_VD = Inverse(X_WV) * ToGround(plant.truth().X_WP);
  taken.pitch_rad = -std::asin(view.z());
  const Camera& camera = plant.built().world.robot.camera.camera;
  taken.guide_px = camera.Project((Inverse(X_WC) * plant.truth().X_WP).p);
  const double hole_px =
      camera.focal_px().x() * std::tan(plant.built().world.robot.camera.half_view_rad);
  taken.in_view = taken.guide_px && (*taken.guide_px - camera.centre_px()).norm() < hole_px - 4.0;
  taken.image = std::get<RgbImage>(plant.TakeImages({kBackCamera}, 0.0).at(0).pixels);
  return taken;
}

}  // namespace dockyard::raposa
