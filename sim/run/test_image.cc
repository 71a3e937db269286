#include "sim/run/test_image.h"

#include <memory>
#include <vector>

#include "controller/geometry/camera.h"
#include "models/read/mesh_loader.h"
#include "render/scene.h"
#include "sim/base/hash.h"
#include "sim/run/drawn_mesh.h"

namespace dockyard {
namespace {

constexpr double kDiscRadius_m = 0.12, kHeight_m = 0.5, kRange_m = 1.4;

StereoRig Rig() {
  StereoRig rig;
  rig.left = rig.right = EquidistantCamera(96, 72, kPi / 2.0);
  Eigen::Matrix3d R_RC;  // x to the right, y down, z forward
  R_RC.col(0) = -Eigen::Vector3d::UnitY();
  R_RC.col(1) = -Eigen::Vector3d::UnitZ();
  R_RC.col(2) = Eigen::Vector3d::UnitX();
  rig.X_RL = {R_RC, {0.0, 0.1, kHeight_m}};
  rig.X_RQ = {R_RC, {0.0, -0.1, kHeight_m}};
  return rig;
}

Pose3 BoardInWorld() { return {Rig().X_RL.R, {kRange_m, 0.0, kHeight_m}}; }

constexpr int kNodes = 41;  // a side of the ground, which is 4 m wide

/// A shallow bowl with ripples, without a function of the C library.
std::vector<double> Heights() {
  std::vector<double> heights;
  for (int y = 0; y < kNodes; ++y) {
    for (int x = 0; x < kNodes; ++x) {
      const int dx = x - kNodes / 2, dy = y - kNodes / 2;
      heights.push_back(2e-5 * (dx * dx + dy * dy) + 2e-3 * ((x * y) % 5));
    }
  }
  return heights;
}

SceneObject Box() {
  return {DrawnMesh(BoxMesh({0.3, 0.2, 0.3})), Pose3::Translation(1.2, -0.5, 0.15)};
}

}  // namespace

StereoImages TestImages(StereoRenderer& renderer) {
  const std::vector<double> heights = Heights();
  Scene scene;
  scene.objects = {Box()};
  scene.ground.x0_m = -1.0;
  scene.ground.y0_m = -2.0;
  scene.ground.cell_m = 0.1;
  scene.ground.nx = scene.ground.ny = kNodes;
  scene.ground.heights_m = heights.data();
  scene.board.board.width_m = 0.8;
  scene.board.board.height_m = 0.5;
  scene.board.board.disc_diameter_m = 2.0 * kDiscRadius_m;
  scene.board.board.fiducials = {{}};
  scene.board.X_WB = BoardInWorld();
  scene.tether.points_W = {{0.5, 0.0, 0.2}, {kRange_m, 0.0, 0.25}};
  scene.tether.diameter_m = 0.01;
  scene.light.to_sun_W = Eigen::Vector3d(-0.6, 0.0, 0.8);  // behind the cameras
  return renderer.Render(scene, Rig(), {}, {.noise_key = 1, .pattern_key = 1});
}

std::uint64_t ImageFingerprint(const StereoImages& images) {
  std::uint64_t hash = kHashSeed;
  for (const GrayImage* image : {&images.left, &images.right}) {
    for (const std::uint8_t pixel : image->pixels) hash = HashByte(hash, pixel);
  }
  return hash;
}

bool ShowsTheTestScene(const GrayImage& left) {
  const StereoRig rig = Rig();
  if (left.width != rig.left.width || left.height != rig.left.height) return false;
  const Pose3 X_LB = Inverse(rig.X_RL) * BoardInWorld();
  const auto level = [&](double x_m, double y_m) {
    const Eigen::Vector2d at = *rig.left.Project(X_LB * Eigen::Vector3d(x_m, y_m, 0.0));
    return static_cast<int>(
        left.at(static_cast<int>(at.x() + 0.5), static_cast<int>(at.y() + 0.5)));
  };
  const int disc = level(0.0, 0.0);
  // Ink reflects 0.05 of the light, the plate 0.85.
  for (const double side : {-2.0, 2.0}) {
    if (level(side * kDiscRadius_m, 0.0) < 4 * disc) return false;
  }
  return left.at(0, 0) > 0;
}

}  // namespace dockyard
