// The stains of one object for one camera. No GL.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/flat_view.h"
#include "render/scene.h"

namespace dockyard {

class ObjectStains {
 public:
  ObjectStains(const SceneObject& object, const Pose3& X_WC);

  bool any() const { return !octaves_.empty(); }

  struct Place {
    Tan from;                      // the ray of a view that met the object
    Tan ray;                       // the pixel's own
    float inverse_depth = 0.0f;    // 1/z of what `from` met
    Eigen::Vector3f n_C{0, 0, 0};  // the normal there; of any length
    float half_pixel = 0.0f;       // half a pixel's width in the tan plane
  };
  /// Albedo over its mean where the pixel's own ray meets the surface: the view's ray lies up to
  /// half a pixel beside it, by which a pair's texture would be off.
  float At(const Place& place) const;

 private:
  struct Octave {
    float per_cell = 0.0f, cell_m = 0.0f, amplitude = 0.0f;
    std::uint64_t key = 0;
  };
  std::vector<Octave> octaves_;
  Eigen::Matrix3f R_OC_;
  Eigen::Vector3f p_OC_;
};

}  // namespace dockyard
