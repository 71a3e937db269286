// The scene's lights on its surfaces for one camera and one image, grey or in colour. No GL.
#pragma once

#include <vector>

#include "render/colour_table.h"
#include "render/lamp_light.h"
#include "render/scene.h"
#include "render/shading.h"

namespace dockyard {

/// Red, green, blue; plain floats, which the compiler keeps in registers.
struct Rgb {
  float r = 0.0f, g = 0.0f, b = 0.0f;

  Rgb& operator+=(const Rgb& c) { return *this = *this + c; }
  friend Rgb operator+(const Rgb& a, const Rgb& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
  friend Rgb operator-(const Rgb& a, const Rgb& b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
  friend Rgb operator*(float k, const Rgb& c) { return {k * c.r, k * c.g, k * c.b}; }
};

/// Light (float: grey or one channel; Rgb) per factor: albedo times irradiance of sun, whole sky
/// and the ground's bounce.
template <typename Value>
struct SurfaceLight {
  Value sun{}, sky{}, bounce{};
  std::vector<Value> lamps{};  // per irradiance, one for each lamp of the scene
};

template <typename Value>
struct SceneLight {
  std::vector<SurfaceLight<Value>> surfaces;
  // Which of the surfaces each object, each thin body and the ground has.
  std::vector<std::size_t> objects, thin;
  std::size_t ground = 0;
  struct Paints {
    SurfaceLight<Value> white, black, dust;
  };
  std::vector<Paints> boards;
  SurfaceLight<Value> sky;  // which counts as white
  std::vector<LampLight> lamps;
  bool sunlit = false;

  /// Adds the radiance that the lamps cause at p_C on a surface with the normal n_C.
  void AddLamps(const SurfaceLight<Value>& on, const Eigen::Vector3f& p_C,
                const Eigen::Vector3f& n_C, float times, Value& sum) const {
    for (std::size_t i = 0; i < lamps.size(); ++i) sum += times * lamps[i](p_C, n_C) * on.lamps[i];
  }
};

/// By the surfaces' albedo in one channel. A lamp's light counts as white.
SceneLight<float> LightIn(const Scene& scene, Channel channel, const Pose3& X_WC);
/// By the materials of the table; a board's paints are even greys, its dust has the ground's
/// material. The table has the scene's materials and kinds of lamps.
SceneLight<Rgb> LightBy(const ColourTable& table, const Scene& scene, const Pose3& X_WC);

}  // namespace dockyard
