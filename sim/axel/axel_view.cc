#include "sim/axel/axel_view.h"

#include "sim/axel/build_rocks.h"
#include "sim/base/random.h"
#include "sim/plant/drawn_mesh.h"
#include "sim/run/shade_body.h"

namespace dockyard::axel {
SceneBuilder::SceneBuilder(const RoverModel& rover, const StationModel& station,
                           const SoilModel& soil, Lighting lighting, const Pose3& X_WG,
                           const Seed& run_seed)
    : body_(Convert(rover.body.visuals)),
      left_wheel_(Convert(rover.left_wheel.visuals)),
      right_wheel_(Convert(rover.right_wheel.visuals)),
      arm_(Convert(rover.arm.visuals)),
      station_(Convert(station.module.visuals)),
      stand_(Convert(station.stand_visuals)),
      X_SB_(BoardInStation(station)),
      p_SM_(MouthInStation(station).p),
      p_AT_(rover.arm_length_m, 0.0, 0.0),
      board_(station.board),
      cutout_(CutoutOf(station)),
      soil_rgb_(soil.rgb),
      rock_rgb_(RockAlbedo(soil)),
      tether_diameter_m_(rover.tether.diameter_m),
      lighting_(std::move(lighting)),
      X_WG_(X_WG),
      texture_seed_(StreamKey(run_seed, "texture")) {
  // The module's drawing stands upright; the built one is tipped about the mouth's centre.
  X_S_module_ = MouthInStation(station) * Pose3::Translation(0.0, 0.0, -station.mouth_height_m);
}

std::vector<SceneBuilder::Part> SceneBuilder::Convert(const std::vector<Visual>& visuals) {
  std::vector<Part> parts;
  for (const Visual& visual : visuals) {
    parts.push_back({DrawnMesh(*visual.mesh), visual.X_LV, visual.rgb});
  }
  return parts;
}

void SceneBuilder::Add(std::vector<SceneObject>& objects, const std::vector<Part>& parts,
                       const Pose3& X_WL) {
  for (const Part& part : parts) objects.push_back({part.mesh, X_WL * part.X_LV, part.albedo});
}

void SceneBuilder::AddRocks(const RockBed& bed) {
  if (bed.rocks.empty()) return;
  rocks_ = {{std::make_shared<RenderMesh>(RockMesh(bed)), Pose3{}, rock_rgb_}};
}

Scene SceneBuilder::Make(const Truth& truth, const HeightGrid& ground) const {
  Scene scene;
  Add(scene.objects, body_, truth.X_WR);
  Add(scene.objects, left_wheel_, truth.X_W_left_wheel);
  Add(scene.objects, right_wheel_, truth.X_W_right_wheel);
  Add(scene.objects, arm_, truth.X_WA);
  Add(scene.objects, station_, truth.X_WS * X_S_module_);
  Add(scene.objects, stand_, truth.X_WS);
  Add(scene.objects, rocks_, X_WG_);
  AddSurroundings(lighting_, scene.objects);
  scene.ground = {.X_WG = X_WG_,
                  .x0_m = ground.x0_m,
                  .y0_m = ground.y0_m,
                  .cell_m = ground.cell_m,
                  .nx = ground.nx,
                  .ny = ground.ny,
                  .heights_m = ground.heights_m.data(),
                  .revision = ground.revision,
                  .albedo = soil_rgb_,
                  .texture_seed = texture_seed_};
  scene.boards.push_back({.board = board_,
                          .X_WB = truth.X_WS * X_SB_,
                          .p_BH = cutout_.p_B,
                          .hole_radius_m = cutout_.radius_m,
                          .dust_cover = lighting_.board_dust,
                          .dusty_spots = lighting_.dusty_spots,
                          .dust_seed = texture_seed_,
                          .dust_albedo = soil_rgb_});
  scene.tether.points_W = truth.tether_W;
  scene.tether.diameter_m = tether_diameter_m_;
  scene.light = lighting_.sun_and_sky;
  return scene;
}

StageShapes SceneBuilder::Shapes() const {
  StageShapes shapes;
  const auto add = [&](const char* name, bool robot, const std::vector<Part>& parts,
                       const Pose3& X_OL = {}) {
    if (shapes.bodies.empty() || shapes.bodies.back().name != name) {
      shapes.bodies.push_back({name, robot, {}});
    }
    for (const Part& part : parts) {
      shapes.bodies.back().parts.push_back({part.mesh, X_OL * part.X_LV, part.albedo});
    }
  };
  add("robot", true, body_);
  add("left_wheel", true, left_wheel_);
  add("right_wheel", true, right_wheel_);
  add("arm", true, arm_);
  add("station", false, station_, X_S_module_);
  add("station", false, stand_);
  if (!rocks_.empty()) {
    add("rocks", false, rocks_);
    shapes.bodies.back().about = true;
  }
  for (StageBody& body : SurroundingBodies(lighting_)) shapes.bodies.push_back(std::move(body));
  shapes.points = {
      {"target", "station", p_SM_}, {"tip", "arm", p_AT_}, {"board", "station", X_SB_.p}};
  shapes.board = {"station", X_SB_, board_, cutout_.p_B, cutout_.radius_m};
  shapes.light = lighting_.sun_and_sky;
  shapes.ground_rgb = soil_rgb_;
  shapes.ground_texture_seed = texture_seed_;
  return shapes;
}

}  // namespace dockyard::axel
