#include "sim/spectator/outside_scene.h"

#include <algorithm>

namespace dockyard {

OutsideScenes::OutsideScenes(const LoggedRun& run, const StageShapes& shapes)
    : run_(run), shapes_(shapes), ground_(run) {
  if (run.times_s.empty()) throw DataError("the log has no sample of the world");
  for (const StageBody& body : shapes.bodies) {
    const auto at = std::find(run.body_names.begin(), run.body_names.end(), body.name);
    if (at == run.body_names.end()) throw DataError("the log has no body " + body.name);
    places_.push_back(static_cast<std::size_t>(at - run.body_names.begin()));
  }
}

Scene OutsideScenes::At(std::size_t sample) {
  Scene scene;
  scene.light = LightAt(shapes_, run_.times_s[sample]);
  AddBodies(sample, scene);
  AddGround(sample, scene);
  for (const auto& [name, line] : run_.lines) {
    if (line[sample].points_W.size() < 2) continue;
    scene.tether = {line[sample].points_W, line[sample].diameter_m, line[sample].rgb};
  }
  return scene;
}

void OutsideScenes::AddBodies(std::size_t sample, Scene& scene) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const StageBody& body = shapes_.bodies[i];
    const Pose3& X_WO = run_.X_WO[places_[i]][sample];
    for (const StagePart& part : body.parts) {
      scene.objects.push_back(
          {.mesh = part.mesh, .X_WO = X_WO * part.X_OP, .albedo = part.rgb, .stains = part.stains});
    }
    for (const StageBoard& board : shapes_.boards) {
      if (board.body != body.name) continue;
      scene.boards.push_back({.board = board.board,
                              .X_WB = X_WO * board.X_OB,
                              .p_BH = board.p_BH,
                              .hole_radius_m = board.hole_radius_m,
                              .dusty_spots = {}});
    }
  }
}

void OutsideScenes::AddGround(std::size_t sample, Scene& scene) {
  const LoggedGround* grid = ground_.grid();
  if (grid == nullptr) return;
  ground_.AdvanceTo(run_.times_s[sample]);
  if (revision_ != ground_.revision()) {
    revision_ = ground_.revision();
    heights_m_.clear();
    for (const std::int16_t steps : ground_.heights()) heights_m_.push_back(steps * grid->step_m);
  }
  scene.ground = {.X_WG = run_.X_WG[sample],
                  .x0_m = grid->x0_m,
                  .y0_m = grid->y0_m,
                  .cell_m = grid->cell_m,
                  .nx = static_cast<int>(grid->nx),
                  .ny = static_cast<int>(grid->ny),
                  .heights_m = heights_m_.data(),
                  .revision = revision_,
                  .albedo = shapes_.ground_rgb,
                  .texture_seed = shapes_.ground_texture_seed,
                  .grain = shapes_.ground_grain,
                  .largest_pebble_m = shapes_.largest_pebble_m};
}

}  // namespace dockyard
