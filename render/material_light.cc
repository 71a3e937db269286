#include "render/material_light.h"

#include <algorithm>
#include <stdexcept>

namespace dockyard {
namespace {

Rgb ToRgb(const Eigen::Vector3d& c) {
  return {static_cast<float>(c.x()), static_cast<float>(c.y()), static_cast<float>(c.z())};
}

void RequireInTable(const Scene& scene, const ColourTable& table) {
  const auto require = [](int index, std::size_t count, const char* what) {
    if (index < 0 || index >= static_cast<int>(count)) {
      throw std::invalid_argument(std::string("scene: the colour table has no ") + what + " " +
                                  std::to_string(index));
    }
  };
  const std::size_t materials = table.materials.size();
  for (const SceneObject& object : scene.objects) require(object.material, materials, "material");
  for (const TetherView* body : ThinBodies(scene)) require(body->material, materials, "material");
  require(scene.ground.material, materials, "material");
  for (const Lamp& lamp : scene.lamps) require(lamp.kind, table.white.lamps.size(), "lamp");
}

}  // namespace

MaterialLight::MaterialLight(const Scene& scene, const ColourTable& table, const Pose3& X_WC)
    : sunlit_(scene.light.sun_irradiance > 0.0) {
  RequireInTable(scene, table);
  for (const MaterialColour& colour : table.materials) {
    lights_.push_back(Strengthen(scene, colour));
  }
  white_ = Strengthen(scene, table.white);
  for (const Lamp& lamp : scene.lamps) lamps_.emplace_back(lamp, X_WC);
}

MaterialLight::Lights MaterialLight::Strengthen(const Scene& scene, const MaterialColour& colour) {
  const SunAndSky& light = scene.light;
  const double on_level = light.sun_irradiance * std::max(light.to_sun_W.z(), 0.0);
  Lights lights{.sun = ToRgb(light.sun_irradiance * colour.sun),
                .sky = ToRgb(light.sky_irradiance * colour.sky),
                .bounce = ToRgb(on_level * colour.sun_off_ground +
                                light.sky_irradiance * colour.sky_off_ground),
                .lamps = {}};
  for (const Lamp& lamp : scene.lamps) {
    lights.lamps.push_back(ToRgb(colour.lamps[static_cast<std::size_t>(lamp.kind)]));
  }
  return lights;
}

}  // namespace dockyard
