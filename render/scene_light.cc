#include "render/scene_light.h"

#include <algorithm>

#include "controller/base/check.h"

namespace dockyard {
namespace {

Rgb ToRgb(const Eigen::Vector3d& c) {
  return {static_cast<float>(c.x()), static_cast<float>(c.y()), static_cast<float>(c.z())};
}

void CheckInTable(const Scene& scene, const ColourTable& table) {
  const auto check = [](int index, std::size_t count) {
    DOCKYARD_CHECK(index >= 0 && index < static_cast<int>(count));
  };
  const std::size_t materials = table.materials.size();
  for (const SceneObject& object : scene.objects) check(object.material, materials);
  for (const TetherView* body : ThinBodies(scene)) check(body->material, materials);
  check(scene.ground.material, materials);
  for (const Lamp& lamp : scene.lamps) check(lamp.kind, table.white.lamps.size());
}

SurfaceLight<float> OnAlbedo(const Scene& scene, const Eigen::Vector3d& albedo, Channel channel) {
  const Reflected r = Reflect(scene.light, albedo, channel);
  const auto white = static_cast<float>(albedo.dot(ChannelWeights(channel)));
  return {.sun = static_cast<float>(r.sun),
          .sky = static_cast<float>(r.sky),
          .bounce = static_cast<float>(r.bounce),
          .lamps = std::vector<float>(scene.lamps.size(), white)};
}

SurfaceLight<Rgb> OnMaterial(const Scene& scene, const MaterialColour& colour,
                             double albedo = 1.0) {
  const SunAndSky& light = scene.light;
  const double on_level = light.sun_irradiance * std::max(light.to_sun_W.z(), 0.0);
  SurfaceLight<Rgb> on{.sun = ToRgb(albedo * light.sun_irradiance * colour.sun),
                       .sky = ToRgb(albedo * light.sky_irradiance * colour.sky),
                       .bounce = ToRgb(albedo * (on_level * colour.sun_off_ground +
                                                 light.sky_irradiance * colour.sky_off_ground))};
  for (const Lamp& lamp : scene.lamps) {
    on.lamps.push_back(ToRgb(albedo * colour.lamps[static_cast<std::size_t>(lamp.kind)]));
  }
  return on;
}

template <typename Value>
SceneLight<Value> Lamps(const Scene& scene, const Pose3& X_WC) {
  SceneLight<Value> light;
  for (const Lamp& lamp : scene.lamps) light.lamps.emplace_back(lamp, X_WC);
  light.sunlit = scene.light.sun_irradiance > 0.0;
  return light;
}

}  // namespace

SceneLight<float> LightIn(const Scene& scene, Channel channel, const Pose3& X_WC) {
  SceneLight<float> light = Lamps<float>(scene, X_WC);
  const auto add = [&](const Eigen::Vector3d& albedo) {
    light.surfaces.push_back(OnAlbedo(scene, albedo, channel));
    return light.surfaces.size() - 1;
  };
  const auto grey = [&](double albedo) {
    return OnAlbedo(scene, Eigen::Vector3d::Constant(albedo), channel);
  };
  for (const SceneObject& object : scene.objects) light.objects.push_back(add(object.albedo));
  for (const TetherView* body : ThinBodies(scene)) light.thin.push_back(add(body->albedo));
  light.ground = add(scene.ground.albedo);
  for (const BoardView& board : scene.boards) {
    light.boards.push_back({grey(board.white_albedo), grey(board.black_albedo),
                            OnAlbedo(scene, board.dust_albedo, channel)});
  }
  light.sky = grey(1.0);
  return light;
}

SceneLight<Rgb> LightBy(const ColourTable& table, const Scene& scene, const Pose3& X_WC) {
  CheckInTable(scene, table);
  SceneLight<Rgb> light = Lamps<Rgb>(scene, X_WC);
  const auto place = [](int material) { return static_cast<std::size_t>(material); };
  for (const MaterialColour& colour : table.materials) {
    light.surfaces.push_back(OnMaterial(scene, colour));
  }
  for (const SceneObject& object : scene.objects) light.objects.push_back(place(object.material));
  for (const TetherView* body : ThinBodies(scene)) light.thin.push_back(place(body->material));
  light.ground = place(scene.ground.material);
  for (const BoardView& board : scene.boards) {
    light.boards.push_back({OnMaterial(scene, table.white, board.white_albedo),
                            OnMaterial(scene, table.white, board.black_albedo),
                            light.surfaces[light.ground]});
  }
  light.sky = OnMaterial(scene, table.white);
  return light;
}

}  // namespace dockyard
