#include "render/colour_samples.h"

#include <cmath>

namespace dockyard {
namespace {

constexpr double kCameraHeight_m = 0.1;

SceneObject Object(RenderMesh mesh, const Pose3& X_WO, Paint paint) {
  SceneObject object{std::make_shared<const RenderMesh>(std::move(mesh)), X_WO};
  object.material = paint;
  return object;
}

}  // namespace

RenderMesh BallToRender(double radius_m, int sides) {
  RenderMesh mesh;
  const int rings = sides / 2;
  for (int j = 0; j <= rings; ++j) {
    const double polar = kPi * j / rings;
    for (int i = 0; i < sides; ++i) {
      const double azimuth = 2.0 * kPi * i / sides;
      const Eigen::Vector3d n(std::sin(polar) * std::cos(azimuth),
                              std::sin(polar) * std::sin(azimuth), std::cos(polar));
      mesh.vertices.push_back((radius_m * n).cast<float>());
    }
  }
  const auto at = [&](int j, int i) { return static_cast<std::uint32_t>(j * sides + i % sides); };
  for (int j = 0; j < rings; ++j) {
    for (int i = 0; i < sides; ++i) {
      mesh.triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      mesh.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
  }
  return mesh;
}

ColourView MarksView() {
  ColourView view;
  view.camera = {.width = 320,
                 .height = 240,
                 .lens = BrownPinhole{.fx = 377.0, .fy = 377.0, .cx = 159.5, .cy = 119.5}};
  view.hole.half_angle_rad = 12.5 * kPi / 180.0;
  return view;
}

std::unique_ptr<MarksScene> MarksAt(double distance_m, const Spectrum& light, bool with_floor) {
  auto marks = std::make_unique<MarksScene>();
  marks->spectra = {
      .sun = light,
      .sky = light,
      .lamps = {WhiteDiodeLight()},
      .materials = {EvenGrey(0.3), OrangePaint(), BluePaint(), EvenGrey(0.0), EvenGrey(1.0)}};
  Scene& scene = marks->scene;
  if (with_floor) {
    scene.ground = {.X_WG = {}, .x0_m = -5.0, .y0_m = -5.0, .cell_m = 5.0, .nx = 3, .ny = 3};
    scene.ground.heights_m = marks->heights_m.data();
  }
  scene.ground.grain = 0.0;
  scene.ground.material = kGreyFloor;
  scene.light.to_sun_W = SunAt(2.4, 0.7);
  scene.light.sun_irradiance = 1.0;
  scene.light.sky_irradiance = 0.4;
  const double z = kCameraHeight_m;
  scene.objects = {
      Object(BallToRender(kBallRadius_m), Pose3::Translation(distance_m, 0.0, z), kOrange),
      Object(BoxToRender({0.002, kSquareSide_m, kSquareSide_m}),
             Pose3::Translation(distance_m + kSquareBehind_m + 0.001, 0.0, z), kBlue)};
  scene.interest = Interest{.p_W = {distance_m + 0.05, 0.0, z}, .radius_m = 0.1};
  marks->X_WC = ForwardCamera(0.0, 0.0, z);
  return marks;
}

}  // namespace dockyard
