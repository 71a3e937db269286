// The world that a film draws against the one that the cameras' images have.
#include <gtest/gtest.h>

#include <algorithm>

#include "rocky7/sim/test_scenario.h"
#include "sim/rocky7/rocky7_plant.h"
#include "sim/spectator/aim_point.h"
#include "sim/spectator/outside_scene.h"

namespace dockyard::rocky7 {
namespace {

Scenario Yard(const std::string& keys) {
  Scenario scenario = OnGravel(keys, 1.6, 4.0);
  scenario.rocks.cover = 0.03;
  scenario.light = Light::kHardShadow;
  scenario.sun.moving = true;
  return scenario;
}

/// One sample of what the plant tells a log.
LoggedRun Logged(const Stage& stage) {
  LoggedRun run;
  run.times_s = {0.0};
  for (const BodyPose& body : stage.bodies) {
    run.body_names.push_back(body.name);
    run.X_WO.push_back({body.X_WO});
  }
  run.X_WD = {stage.X_WD};
  run.X_WG = {stage.ground.X_WG};
  constexpr double kStep_m = 1e-4;
  LoggedGround ground{.x0_m = stage.ground.x0_m,
                      .y0_m = stage.ground.y0_m,
                      .cell_m = stage.ground.cell_m,
                      .step_m = kStep_m,
                      .nx = static_cast<std::uint32_t>(stage.ground.nx),
                      .ny = static_cast<std::uint32_t>(stage.ground.ny),
                      .cells = {},
                      .heights = {}};
  for (std::uint32_t i = 0; i < ground.nx * ground.ny; ++i) {
    ground.heights.push_back(
        static_cast<std::int16_t>(std::lround(stage.ground.heights_m[i] / kStep_m)));
  }
  run.ground = {{0.0, ground}};
  return run;
}

bool SamePlace(const Pose3& a, const Pose3& b) {
  return (a.p - b.p).norm() < 1e-9 && (a.R - b.R).norm() < 1e-9;
}

bool Same(const SceneObject& a, const SceneObject& b) {
  return a.mesh->vertices == b.mesh->vertices && a.mesh->triangles == b.mesh->triangles &&
         SamePlace(a.X_WO, b.X_WO) && a.albedo == b.albedo &&
         a.stains.contrast == b.stains.contrast && a.stains.seed == b.stains.seed &&
         a.stains.largest_m == b.stains.largest_m && a.stains.least_m == b.stains.least_m;
}

// All shapes with their stains, the ground with its grain, and the light.
TEST(Rocky7Film, DrawsTheWorldOfTheCamerasImages) {
  for (const char* keys : {"{task: grasp, gravel_m: 0.015}", "{task: reach}",
                           "{task: place, target_up_m: 0.33, stone_stains: 0.17}"}) {
    const Scenario scenario = Yard(keys);
    const BuiltRun built = BuildRun(scenario, LoadModels(scenario));
    Rocky7Plant plant(scenario, built, std::make_shared<KeptRenderer>());
    const World world(built.world);
    const SceneBuilder builder(built, world.rover(), scenario.seed);
    const Scene images = builder.Make(world.truth(), world.ground());
    const LoggedRun run = Logged(plant.Look());
    const StageShapes shapes = builder.Shapes();
    OutsideScenes films(run, shapes);
    const Scene film = films.At(0);

    EXPECT_EQ(film.objects.size(), images.objects.size()) << keys;
    for (const SceneObject& object : images.objects) {
      EXPECT_TRUE(std::any_of(film.objects.begin(), film.objects.end(),
                              [&](const SceneObject& other) { return Same(object, other); }))
          << keys << ": object at " << object.X_WO.p.transpose();
    }
    EXPECT_EQ(film.ground.albedo, images.ground.albedo);
    EXPECT_EQ(film.ground.texture_seed, images.ground.texture_seed);
    EXPECT_EQ(film.ground.grain, images.ground.grain);
    EXPECT_EQ(film.ground.largest_pebble_m, images.ground.largest_pebble_m);
    EXPECT_TRUE(SamePlace(film.ground.X_WG, images.ground.X_WG));
    EXPECT_NEAR(film.ground.heights_m[1234], images.ground.heights_m[1234], 0.6e-4);
    EXPECT_EQ(film.light.to_sun_W, images.light.to_sun_W);
    EXPECT_EQ(shapes.to_pole_W, built.lighting.to_pole_W);
    EXPECT_EQ(film.light.sky_irradiance, images.light.sky_irradiance);
  }
}

// The judge's target of a placement is a point of the boulder's face, and so is the film's.
TEST(Rocky7Film, IsAimedAtTheJudgesTarget) {
  const Scenario scenario = Yard("{task: place, target_up_m: 0.33}");
  const BuiltRun built = BuildRun(scenario, LoadModels(scenario));
  Rocky7Plant plant(scenario, built, std::make_shared<KeptRenderer>());
  const World world(built.world);
  const SceneBuilder builder(built, world.rover(), scenario.seed);
  const Eigen::Vector3d target_W =
      AimPlace({"target", std::nullopt}, Logged(plant.Look()), builder.Shapes(), 0);
  EXPECT_LT((target_W - plant.X_WG() * world.truth().X_GT.p).norm(), 1e-9);
}

}  // namespace
}  // namespace dockyard::rocky7
