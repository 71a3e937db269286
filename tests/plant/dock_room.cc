#include "plant/dock_room.h"

#include <cmath>

#include "render/scene_samples.h"

namespace dockyard {
namespace {

constexpr int kNodes = 601;  // 12 m at 20 mm
constexpr double kHalf_m = 6.0, kCamera_m = 0.25;

SceneObject Thing(RenderMesh mesh, const Pose3& X, double albedo) {
  return {.mesh = std::make_shared<const RenderMesh>(std::move(mesh)),
          .X_WO = X,
          .albedo = Eigen::Vector3d::Constant(albedo)};
}

FiducialBoard SmallBoard() {
  FiducialBoard board{.width_m = 0.16, .height_m = 0.16, .disc_diameter_m = 0.03, .fiducials = {}};
  for (const double x : {-0.055, 0.0, 0.055}) {
    for (const double y : {-0.055, 0.0, 0.055}) {
      if (x == 0.0 && y == 0.0) continue;
      board.fiducials.push_back({{x + 0.004 * y / 0.055, y}, 0.0});
    }
  }
  return board;
}

void AddWalls(std::vector<SceneObject>& objects) {
  for (const double side : {-1.0, 1.0}) {
    objects.push_back(
        Thing(BoxToRender({0.1, 12.0, 2.5}), Pose3::Translation(side * 5.9, 0.0, 1.25), 0.6));
    objects.push_back(
        Thing(BoxToRender({11.6, 0.1, 2.5}), Pose3::Translation(0.0, side * 5.9, 1.25), 0.55));
  }
}

void AddBoxes(std::vector<SceneObject>& objects) {
  for (int i = 0; i < 10; ++i) {
    const double angle = 2.0 * kPi * i / 10.0 + 0.3, r = 2.0 + 0.3 * i;
    const double side = 0.3 + 0.05 * i;
    objects.push_back(Thing(BoxToRender({side, 0.8 * side, side}),
                            {RotZ(0.7 * i), {r * std::cos(angle), r * std::sin(angle), 0.5 * side}},
                            0.2 + 0.05 * i));
  }
}

}  // namespace

DockRoom::DockRoom(double sun_irradiance)
    : heights_m(static_cast<std::size_t>(kNodes) * kNodes, 0.0) {
  AddWalls(still.objects);
  AddBoxes(still.objects);
  // The dock: a plate on the floor and a box whose face carries the board.
  still.objects.push_back(
      Thing(BoxToRender({0.3, 0.3, 0.02}), Pose3::Translation(0.1, 0, 0.01), 0.3));
  still.objects.push_back(
      Thing(BoxToRender({0.1, 0.3, 0.4}), Pose3::Translation(-0.052, 0, 0.2), 0.4));
  BoardView board{
      .board = SmallBoard(), .X_WB = UprightBoard(0.0, 0.0, kCamera_m), .dusty_spots = {}};
  still.boards.push_back(board);
  still.ground = {.X_WG = {},
                  .x0_m = -kHalf_m,
                  .y0_m = -kHalf_m,
                  .cell_m = 2.0 * kHalf_m / (kNodes - 1),
                  .nx = kNodes,
                  .ny = kNodes,
                  .albedo = Eigen::Vector3d::Constant(0.4),
                  .grain = 0.0};
  still.light.to_sun_W = SunAt(0.8, 0.9);
  still.light.sun_irradiance = sun_irradiance;
  still.light.sky_irradiance = 0.8;
  // Wheels and body are behind the camera and under it.
  const auto part = [&](RenderMesh mesh, const Pose3& X_CO, double albedo) {
    robot_C.push_back(Thing(std::move(mesh), X_CO, albedo));
  };
  part(CylinderToRender(0.17, 0.1, 400), {RotX(kPi / 2), {0.0, 0.1, -0.2}}, 0.2);
  part(BoxToRender({0.3, 0.15, 0.05}), Pose3::Translation(0.0, 0.18, 0.08), 0.25);
  for (const double side : {-0.18, 0.18}) {
    part(CylinderToRender(0.05, 0.03, 64), {RotY(kPi / 2), {side, 0.2, -0.2}}, 0.1);
  }
  part(CylinderToRender(0.01, 0.4, 24), {RotX(kPi / 2), {0.1, -0.2, -0.25}}, 0.5);
}

Pose3 DockRoom::CameraAt(double range_m, double off_m, double yaw_rad) const {
  Pose3 X_WC = LevelRover(range_m, off_m, kPi + yaw_rad, 0.0) * ForwardCamera(0, 0, kCamera_m);
  return X_WC;
}

Scene DockRoom::SceneAt(const Pose3& X_WC) const {
  Scene scene = still;
  scene.ground.heights_m = heights_m.data();
  for (SceneObject part : robot_C) {
    part.X_WO = X_WC * part.X_WO;
    scene.objects.push_back(std::move(part));
  }
  return scene;
}

}  // namespace dockyard
