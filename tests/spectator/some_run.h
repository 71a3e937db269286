// A logged run of a box that drives towards a target.
#pragma once

#include "sim/log/logged_run.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// Two samples: the box at x = 3 m and at 2 m; the site is level, the target at the world's origin.
inline LoggedRun SomeRun() {
  LoggedRun run;
  run.times_s = {0.0, 0.1};
  run.X_WG = run.X_WD = {Pose3{}, Pose3{}};
  run.body_names = {"robot", "target"};
  run.X_WO = {{Pose3::Translation(3.0, 0.0, 0.2), Pose3::Translation(2.0, 0.0, 0.2)},
              {Pose3{}, Pose3{}}};
  constexpr std::uint32_t kNodes = 101;
  run.ground = {{0.0,
                 {.x0_m = -5.0,
                  .y0_m = -5.0,
                  .cell_m = 0.1,
                  .step_m = 1e-4,
                  .nx = kNodes,
                  .ny = kNodes,
                  .cells = {},
                  .heights = std::vector<std::int16_t>(kNodes * kNodes, 0)}}};
  return run;
}

inline std::shared_ptr<const RenderMesh> Box(double side_m) {
  auto mesh = std::make_shared<RenderMesh>();
  const float h = static_cast<float>(0.5 * side_m);
  for (int i = 0; i < 8; ++i) {
    mesh->vertices.emplace_back(i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h);
  }
  mesh->triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A red robot and a blue target, cubes of 0.4 and 0.2 m.
inline StageShapes SomeShapes() {
  StageShapes shapes;
  shapes.bodies.push_back({"robot", true, {{Box(0.4), {}, {0.8, 0.02, 0.02}}}});
  shapes.bodies.push_back(
      {"target", false, {{Box(0.2), Pose3::Translation(0.0, 0.0, 0.1), {0.02, 0.02, 0.8}}}});
  shapes.light.to_sun_W = Eigen::Vector3d(0.3, 0.4, 0.866).normalized();
  return shapes;
}

}  // namespace dockyard
