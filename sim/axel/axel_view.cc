#include "sim/axel/axel_view.h"

#include "sim/axel/build_rocks.h"
#include "sim/base/random.h"
#include "sim/plant/drawn_mesh.h"
#include "sim/plant/ground_view.h"
#include "sim/plant/sun_motion.h"
#include "sim/run/shade_body.h"

namespace dockyard::axel {
SceneBuilder::SceneBuilder(const RoverModel& rover, const StationModel& station,
                           const SoilModel& soil, Lighting lighting, const Pose3& X_WG,
                           const Seed& run_seed)
    : body_(DrawnParts(rover.body.visuals)),
      left_wheel_(DrawnParts(rover.left_wheel.visuals)),
      right_wheel_(DrawnParts(rover.right_wheel.visuals)),
      arm_(DrawnParts(rover.arm.visuals)),
      station_(DrawnParts(station.module.visuals)),
      stand_(DrawnParts(station.stand_visuals)),
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
  for (const JointedLink& each : rover.further.links) {
    further_.push_back({each.link.name, DrawnParts(each.link.visuals)});
  }
  // The module's drawing stands upright; the built one is tipped about the mouth's centre.
  X_S_module_ = MouthInStation(station) * Pose3::Translation(0.0, 0.0, -station.mouth_height_m);
}

void SceneBuilder::AddRocks(const RockBed& bed) {
  if (bed.rocks.empty()) return;
  rocks_ = {{std::make_shared<RenderMesh>(RockMesh(bed)), Pose3{}, rock_rgb_}};
}

Scene SceneBuilder::Make(const Truth& truth, const HeightGrid& ground) const {
  Scene scene;
  AddParts(body_, truth.X_WR, scene.objects);
  AddParts(left_wheel_, truth.X_W_left_wheel, scene.objects);
  AddParts(right_wheel_, truth.X_W_right_wheel, scene.objects);
  AddParts(arm_, truth.X_WA, scene.objects);
  for (std::size_t i = 0; i < further_.size(); ++i) {
    AddParts(further_[i].parts, truth.further[i].X_WL, scene.objects);
  }
  AddParts(station_, truth.X_WS * X_S_module_, scene.objects);
  AddParts(stand_, truth.X_WS, scene.objects);
  AddParts(rocks_, X_WG_, scene.objects);
  AddSurroundings(lighting_, scene.objects);
  scene.ground = ViewOf(ground, X_WG_, soil_rgb_, texture_seed_);
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
  scene.light = LightAt(lighting_, truth.time_s);
  return scene;
}

StageShapes SceneBuilder::Shapes() const {
  StageShapes shapes;
  const auto add = [&](const std::string& name, bool robot, const std::vector<DrawnPart>& parts,
                       const Pose3& X_OL = {}) {
    if (shapes.bodies.empty() || shapes.bodies.back().name != name) {
      shapes.bodies.push_back({name, robot, {}});
    }
    AddParts(parts, X_OL, shapes.bodies.back());
  };
  add("robot", true, body_);
  add("left_wheel", true, left_wheel_);
  add("right_wheel", true, right_wheel_);
  add("arm", true, arm_);
  for (const DrawnLink& link : further_) add(link.name, true, link.parts);
  add("station", false, station_, X_S_module_);
  add("station", false, stand_);
  if (!rocks_.empty()) {
    add("rocks", false, rocks_);
    shapes.bodies.back().about = true;
  }
  for (StageBody& body : SurroundingBodies(lighting_)) shapes.bodies.push_back(std::move(body));
  shapes.points = {
      {"target", "station", p_SM_}, {"tip", "arm", p_AT_}, {"board", "station", X_SB_.p}};
  shapes.boards = {{"station", X_SB_, board_, cutout_.p_B, cutout_.radius_m}};
  shapes.light = lighting_.sun_and_sky;
  shapes.to_pole_W = lighting_.to_pole_W;
  shapes.ground_rgb = soil_rgb_;
  shapes.ground_texture_seed = texture_seed_;
  return shapes;
}

}  // namespace dockyard::axel
