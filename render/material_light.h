// The scene's lights on its materials for one camera and one image. No GL.
#pragma once

#include <array>
#include <vector>

#include "render/colour_table.h"
#include "render/lamp_light.h"
#include "render/scene.h"

namespace dockyard {

/// Red, green, blue; plain floats, which the compiler keeps in registers.
struct Rgb {
  float r = 0.0f, g = 0.0f, b = 0.0f;

  void Add(const Rgb& c, float times) {
    r += times * c.r;
    g += times * c.g;
    b += times * c.b;
  }
};

class MaterialLight {
 public:
  /// Throws std::invalid_argument when the scene names a material or a kind of lamp that the table
  /// does not have.
  MaterialLight(const Scene& scene, const ColourTable& table, const Pose3& X_WC);

  /// Colour per factor: albedo times irradiance of sun, whole sky and the ground's bounce.
  struct Lights {
    Rgb sun, sky, bounce;
    std::vector<Rgb> lamps;  // per irradiance, one for each lamp of the scene
  };
  const Lights& of(int material) const { return lights_[static_cast<std::size_t>(material)]; }
  /// Of the sky itself, which counts as white.
  const Lights& white() const { return white_; }

  bool has_lamps() const { return !lamps_.empty(); }
  bool sunlit() const { return sunlit_; }
  /// Adds the radiance that the lamps cause at p_C on a surface with the normal n_C.
  void AddLamps(const Lights& lights, const Eigen::Vector3f& p_C, const Eigen::Vector3f& n_C,
                float times, Rgb& sum) const {
    for (std::size_t i = 0; i < lamps_.size(); ++i) {
      sum.Add(lights.lamps[i], times * lamps_[i](p_C, n_C));
    }
  }

 private:
  static Lights Strengthen(const Scene& scene, const MaterialColour& colour);

  std::vector<Lights> lights_;
  Lights white_;
  std::vector<LampLight> lamps_;
  bool sunlit_ = false;
};

}  // namespace dockyard
