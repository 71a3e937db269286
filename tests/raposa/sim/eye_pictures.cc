#include "raposa/sim/eye_pictures.h"

#include <cmath>

#include "controller/raposa/drive.h"
#include "models/read/yaml_tree.h"
#include "sim/base/random.h"
#include "sim/plant/placement.h"
#include "sim/plant/scenery.h"
#include "sim/raposa/raposa_plant.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

// Materials of SceneBuilder's scenes.
constexpr int kOrangePaint = 1, kBluePaint = 2;

/// A ball, an upright cylinder or a box of the size 1, about its middle.
std::shared_ptr<const RenderMesh> Shape(int kind) {
  auto mesh = std::make_shared<RenderMesh>();
  const int rings = kind == 0 ? 8 : 1, sides = kind == 2 ? 4 : 16;
  for (int i = 0; i <= rings; ++i) {
    const double along = static_cast<double>(i) / rings;
    const double z = kind == 0 ? -0.5 * std::cos(kPi * along) : along - 0.5;
    const double radius = kind == 0 ? 0.5 * std::sin(kPi * along) : kind == 1 ? 0.5 : 0.7071;
    for (int k = 0; k < sides; ++k) {
      const double turn = 2.0 * kPi * (k + 0.5) / sides;
      mesh->vertices.push_back(
          Eigen::Vector3d(radius * std::cos(turn), radius * std::sin(turn), z).cast<float>());
    }
  }
  const auto at = [&](int ring, int k) {
    return static_cast<std::uint32_t>(ring * sides + k % sides);
  };
  for (int i = 0; i < rings; ++i) {
    for (int k = 0; k < sides; ++k) {
      mesh->triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      mesh->triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  }
  for (int k = 1; k + 1 < sides; ++k) {
    mesh->triangles.push_back({at(rings, 0), at(rings, k), at(rings, k + 1)});
  }
  return mesh;
}

void AddForgeries(Scene& scene, const Pose3& X_WC, std::uint64_t seed) {
  RandomStream random(StreamKey(seed, "clutter"));
  const Eigen::Vector3d view = X_WC.R.col(2);
  const double ahead_rad = std::atan2(view.y(), view.x());
  const int count = 2 + static_cast<int>(random.Uniform(0.0, 5.0));
  double r_m = 1.0, aside_rad = 0.0;
  for (int i = 0; i < count; ++i) {
    // Every other one stands close to the one before, in the other colour.
    const bool beside = i % 2 == 1;
    r_m = beside ? r_m + random.Uniform(-0.1, 0.15) : random.Uniform(0.4, 4.0);
    aside_rad =
        beside ? aside_rad + random.Uniform(-0.15, 0.15) / r_m : Radians(random.Uniform(-10, 10));
    const Eigen::Vector3d size(random.Uniform(0.02, 0.12), random.Uniform(0.02, 0.12),
                               random.Uniform(0.02, 0.12));
    const double from_ground_m = random.Uniform(0.0, 0.05) + 0.5 * size.z();
    SceneObject object;
    object.mesh = Shape(static_cast<int>(random.Uniform(0.0, 3.0)));
    auto scaled = std::make_shared<RenderMesh>(*object.mesh);
    for (auto& vertex : scaled->vertices) vertex = vertex.cwiseProduct(size.cast<float>());
    object.mesh = scaled;
    object.X_WO.R = RotZ(random.Uniform(0.0, 2.0 * kPi));
    object.X_WO.p = {X_WC.p.x() + r_m * std::cos(ahead_rad + aside_rad),
                     X_WC.p.y() + r_m * std::sin(ahead_rad + aside_rad), from_ground_m};
    object.material = beside == (random.Uniform() < 0.8) ? kBluePaint : kOrangePaint;
    scene.objects.push_back(object);
  }
}

/// The camera's place, x along its view.
Pose2 PlanOf(const Pose3& X_WC) {
  const Eigen::Vector3d view = X_WC.R.col(2);
  return {X_WC.p.x(), X_WC.p.y(), std::atan2(view.y(), view.x())};
}

/// Around a point ahead. DrawClutter keeps things off a pyramid and the way to it; here the camera
/// stands in their place.
std::vector<SceneryItem> ThingsAhead(const Pose2& X_DV, std::uint64_t seed) {
  constexpr int kCount = 40;
  constexpr double kAhead_m = 2.5, kNearest_m = 0.3;
  std::vector<SceneryItem> pieces = DrawClutter(kCount, {-100.0, 0.0, kPi}, 10.0, seed);
  for (SceneryItem& piece : pieces) piece.X_DO = X_DV * Pose2{kAhead_m, 0.0, kPi / 2} * piece.X_DO;
  std::erase_if(pieces, [&](const SceneryItem& piece) {
    return std::hypot(piece.X_DO.x - X_DV.x, piece.X_DO.y - X_DV.y) < kNearest_m + RadiusOf(piece);
  });
  return pieces;
}

Scenario ScenarioOf(const ImageSetup& setup) {
  const std::string models = SourceFile("models/raposa/");
  Scenario scenario;
  scenario.robot_file = models + "raposa.yaml";
  scenario.soil_file = models + "grounds/" + setup.ground + ".yaml";
  scenario.of_system = ParseYaml(
      "{pyramid: " + models + "pyramid/pyramid.yaml, light_k: " + std::to_string(setup.light_k) +
          ", light_level: " + std::to_string(setup.light_level) + ", balance_k: " +
          std::to_string(setup.balance_k) + ", clutter: " + std::to_string(setup.things) + "}",
      "test");
  scenario.start = {setup.r_m, setup.alpha_rad, setup.alpha_rad + setup.beside_rad};
  scenario.yard.undulation_rms_m = setup.undulation_rms_m;
  scenario.seed = setup.seed;
  scenario.light = setup.light == "even"       ? Light::kEven
                   : setup.light == "speckled" ? Light::kSpeckled
                                               : Light::kHardShadow;
  return scenario;
}

}  // namespace

TakenImage ExposeColourViewOf(const ImageSetup& setup,
                              const std::shared_ptr<KeptRenderer>& renderer) {
  const Scenario scenario = ScenarioOf(setup);
  RaposaPlant plant(scenario, BuildRun(scenario, LoadModels(scenario)), renderer);
  if (setup.lamps || setup.arm_rad > 0.0) {
    Commands commands = BrakedCommands();
    commands.switches[kLamps] = setup.lamps ? 1 : 0;
    SetArm(plant.built().nominal, setup.arm_rad, &commands);
    const int periods = setup.arm_rad > 0.0 ? 30 : 1;
    for (int i = 0; i < periods; ++i) plant.Advance(commands);
    plant.RefreshTruth();
  }
  TakenImage taken;
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

TakenImage TakeClutterOf(const ImageSetup& setup, const std::shared_ptr<KeptRenderer>& renderer,
                         Instead instead) {
  const Scenario scenario = ScenarioOf(setup);
  RaposaPlant plant(scenario, BuildRun(scenario, LoadModels(scenario)), renderer);
  BuiltRun built = plant.built();
  built.keys.hide_pyramid = true;
  const BackCameraModel& camera = built.world.robot.camera;
  const Pose3 X_WC = plant.truth().X_WR * camera.X_RC;
  if (instead == Instead::kThings) {
    built.clutter = ThingsAhead(Inverse(built.world.X_GD) * PlanOf(X_WC), setup.seed);
  }
  Lighting lighting =
      MakeLighting(scenario.light, FromGround(built.world.X_GD, 0.0),
                   {0.0, 0.0, built.world.pyramid.guide.height_m}, scenario.seed, scenario.sun);
  AddItems(built.clutter, built.world.ground, FromGround({}, 0.0), built.world.X_GD, lighting);
  const SceneBuilder builder(built, lighting, scenario.seed);
  Scene scene = builder.Make(plant.truth(), plant.world().ground(), setup.lamps);
  scene.tether.points_W.clear();
  if (instead == Instead::kForgeries) AddForgeries(scene, X_WC, setup.seed);
  const ColourRadiance light =
      renderer->Get().RenderThrough(scene, builder.colours(), ViewOf(camera), {X_WC});
  ColourSensorState state;
  TakenImage taken;
  taken.nominal = built.nominal;
  taken.pitch_rad = -std::asin(X_WC.R(2, 2));
  taken.image = ExposeColourView(light, SensorOf(camera, setup.balance_k), 0.0,
                                 StreamKey(setup.seed, "camera"), state);
  return taken;
}

}  // namespace dockyard::raposa
