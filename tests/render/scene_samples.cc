#include "render/scene_samples.h"

#include <cmath>

namespace dockyard {
namespace {

constexpr double kCell_m = 0.02;
constexpr int kNx = 500, kNy = 300;  // 10 m x 6 m
constexpr double kX0_m = -2.0, kY0_m = -3.0;

std::vector<double> HeightsWithRut() {
  std::vector<double> heights(static_cast<std::size_t>(kNx) * kNy);
  for (int iy = 0; iy < kNy; ++iy) {
    for (int ix = 0; ix < kNx; ++ix) {
      const double x = kX0_m + ix * kCell_m, y = kY0_m + iy * kCell_m;
      double h = 0.015 * std::sin(1.7 * x + 0.6) * std::cos(1.3 * y) + 0.01 * std::sin(3.1 * y + x);
      h *= std::min(1.0, std::hypot(x, y) / 1.5);
      for (const double side : {-0.45, 0.35}) {
        const double off = y - side - 0.12 * std::sin(0.9 * x);
        // A wheel's track: 3 cm deep, berms at both sides, cross bars of the paddles.
        const double track = std::exp(-std::pow(off / 0.07, 4));
        const double berm = std::exp(-std::pow((std::abs(off) - 0.10) / 0.03, 2));
        const double bars = 0.006 * std::sin(2.0 * kPi * x / 0.12);
        const double here = x > 1.0 ? 1.0 : 0.0;
        h += here * (-0.030 * track + 0.012 * berm + bars * track);
      }
      heights[static_cast<std::size_t>(iy) * kNx + ix] = h;
    }
  }
  return heights;
}

std::shared_ptr<const RenderMesh> Share(RenderMesh mesh) {
  return std::make_shared<const RenderMesh>(std::move(mesh));
}

void AddStation(Scene& scene) {
  const Eigen::Vector3d grey(0.62, 0.62, 0.6);
  // Module behind the board's plane, legs, a dark mouth.
  scene.objects.push_back(
      {Share(BoxToRender({0.8, 1.0, 0.95})), Pose3::Translation(-0.41, 0, 0.62), grey});
  for (const double y : {-0.45, 0.45}) {
    for (const double x : {-0.1, -0.75}) {
      scene.objects.push_back({Share(CylinderToRender(0.03, 0.2)), Pose3::Translation(x, y, 0.08),
                               Eigen::Vector3d(0.3, 0.3, 0.32)});
    }
  }
  Pose3 X_WK = Pose3::Translation(0.02, 0, 0.42);
  X_WK.R = RotY(kPi / 2);
  scene.objects.push_back(
      {Share(CylinderToRender(0.17, 0.06, 48)), X_WK, Eigen::Vector3d(0.5, 0.5, 0.5)});
  X_WK.p.x() = 0.03;
  scene.objects.push_back(
      {Share(CylinderToRender(0.12, 0.05, 48)), X_WK, Eigen::Vector3d(0.03, 0.03, 0.03)});
}

void AddRover(Yard& yard) {
  Scene& scene = yard.scene;
  const auto add = [&](RenderMesh mesh, const Pose3& X_RO, double albedo) {
    scene.objects.push_back(
        {Share(std::move(mesh)), yard.X_WR * X_RO, Eigen::Vector3d::Constant(albedo)});
  };
  Pose3 X_RA = Pose3::Translation(0.45, 0, 0.02);
  X_RA.R = RotY(kPi / 2);
  add(CylinderToRender(0.025, 0.9), X_RA, 0.55);
  for (const double y : {-0.5, 0.5}) {
    Pose3 X_RK = Pose3::Translation(0, y, 0);
    X_RK.R = RotX(kPi / 2);
    add(CylinderToRender(0.15, 0.14), X_RK, 0.35);
  }
  add(BoxToRender({0.2, 0.7, 0.15}), Pose3::Translation(-0.05, 0, 0), 0.4);
  const Eigen::Vector3d tip_W = yard.X_WR * Eigen::Vector3d(0.9, 0, 0.02);
  const Eigen::Vector3d anchor_W(-0.02, 0, 0.42);
  for (int i = 0; i <= 24; ++i) {
    const double t = i / 24.0;
    Eigen::Vector3d p = tip_W + t * (anchor_W - tip_W);
    p.z() -= 0.05 * 4.0 * t * (1.0 - t);
    scene.tether.points_W.push_back(p);
  }
  scene.tether.diameter_m = 0.006;
}

}  // namespace

RenderMesh BoxToRender(const Eigen::Vector3d& size_m) {
  RenderMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
    mesh.vertices.push_back(corner.cwiseProduct(size_m).cast<float>());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

RenderMesh CylinderToRender(double radius_m, double length_m, int sides) {
  RenderMesh mesh;
  for (const double z : {-0.5 * length_m, 0.5 * length_m}) {
    for (int k = 0; k < sides; ++k) {
      const double angle = 2.0 * kPi * k / sides;
      mesh.vertices.push_back(
          Eigen::Vector3d(radius_m * std::cos(angle), radius_m * std::sin(angle), z).cast<float>());
    }
    mesh.vertices.push_back(Eigen::Vector3f(0, 0, static_cast<float>(z)));
  }
  const auto n = static_cast<std::uint32_t>(sides), top = n + 1;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    mesh.triangles.push_back({k, next, top + k});
    mesh.triangles.push_back({next, top + next, top + k});
    mesh.triangles.push_back({n, next, k});
    mesh.triangles.push_back({top + n, top + k, top + next});
  }
  return mesh;
}

Pose3 ForwardCamera(double x_m, double y_m, double z_m, double pitch_rad) {
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // columns: right, down, forward
  return {RotY(pitch_rad) * axes, {x_m, y_m, z_m}};
}

StereoRig SampleRig(int width, int height) {
  const Camera camera = EquidistantCamera(width, height, kPi / 2);
  return {.left = camera,
          .right = camera,
          .X_RL = ForwardCamera(0.05, 0.175, 0.25, 0.05),
          .X_RQ = ForwardCamera(0.05, -0.175, 0.25, 0.05)};
}

FiducialBoard SampleBoard() {
  FiducialBoard board{
      .width_m = 0.9, .height_m = 0.5, .bar_length_m = 0.07, .bar_width_m = 0.02, .fiducials = {}};
  board.fiducials = {{{-0.37, -0.17}, 0.0},    {{-0.12, -0.18}, kPi / 4},
                     {{0.13, -0.15}, kPi / 2}, {{0.37, -0.18}, -kPi / 4},
                     {{-0.36, 0.16}, kPi / 2}, {{-0.10, 0.10}, -kPi / 4},
                     {{0.16, 0.17}, 0.0},      {{0.37, 0.10}, kPi / 4}};
  return board;
}

Pose3 UprightBoard(double x_m, double y_m, double z_m) {
  Eigen::Matrix3d axes;
  axes << 0, 0, -1, 1, 0, 0, 0, -1, 0;  // columns: viewer's right, down, into the station
  return {axes, {x_m, y_m, z_m}};
}

Pose3 LevelRover(double x_m, double y_m, double heading_rad, double z_m) {
  return {RotZ(heading_rad), {x_m, y_m, z_m}};
}

Eigen::Vector3d SunAt(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad),
          std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

Scene BoardOnly() {
  Scene scene;
  scene.boards.push_back(
      {.board = SampleBoard(), .X_WB = UprightBoard(0, 0, 0.7), .dusty_spots = {}});
  scene.light.to_sun_W = SunAt(0.3, 0.8);
  return scene;
}

std::unique_ptr<Yard> SampleYard(double range_m, const Eigen::Vector3d& to_sun_W) {
  auto yard = std::make_unique<Yard>();
  yard->heights_m = HeightsWithRut();
  Scene& scene = yard->scene;
  scene.ground = {.X_WG = {},
                  .x0_m = kX0_m,
                  .y0_m = kY0_m,
                  .cell_m = kCell_m,
                  .nx = kNx,
                  .ny = kNy,
                  .heights_m = yard->heights_m.data()};
  scene.boards.push_back(
      {.board = SampleBoard(), .X_WB = UprightBoard(0.0, 0, 0.85), .dusty_spots = {}});
  scene.light.to_sun_W = to_sun_W;
  yard->X_WR = LevelRover(range_m, 0.0, kPi);
  AddStation(scene);
  AddRover(*yard);
  for (const auto& [x, y] : {std::pair(-1.0, 2.2), {1.2, -1.6}}) {
    scene.objects.push_back({Share(CylinderToRender(0.04, 1.8)), Pose3::Translation(x, y, 0.9),
                             Eigen::Vector3d(0.4, 0.35, 0.3)});
  }
  return yard;
}

void AddCanopy(Yard& yard) {
  // Its lower edge lies on the ray to the sun from the board's middle, tilted a little.
  Pose3 X_WO;
  const Eigen::Vector3d s = yard.scene.light.to_sun_W;
  X_WO.p = yard.scene.boards[0].X_WB.p + 3.0 * s + Eigen::Vector3d(0, 0, 0.75);
  X_WO.R = RotX(0.25);
  yard.scene.objects.push_back(
      {Share(BoxToRender({0.05, 3.0, 1.5})), X_WO, Eigen::Vector3d(0.4, 0.4, 0.4)});
}

std::unique_ptr<Yard> Moved(const Yard& yard, double x_m, double y_m, double turn_rad) {
  auto moved = std::make_unique<Yard>(yard);
  const Pose3 X_VW{RotZ(turn_rad), {x_m, y_m, 0.0}};
  moved->X_WR = X_VW * yard.X_WR;
  Scene& scene = moved->scene;
  for (SceneObject& object : scene.objects) object.X_WO = X_VW * object.X_WO;
  for (Eigen::Vector3d& p : scene.tether.points_W) p = X_VW * p;
  scene.ground.X_WG = X_VW * scene.ground.X_WG;
  scene.ground.heights_m = moved->heights_m.data();
  scene.boards[0].X_WB = X_VW * scene.boards[0].X_WB;
  scene.light.to_sun_W = X_VW.R * scene.light.to_sun_W;
  return moved;
}

}  // namespace dockyard
