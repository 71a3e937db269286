// A part of the tan plane, (x, y) = ray.xy / ray.z in the camera frame, and the hits of a flat view
// of it along each of its rays: which kind of surface and how far. Light comes later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace dockyard {

/// A point or a step of the tan plane; two plain floats, which the compiler keeps in registers.
struct Tan {
  float x = 0.0f, y = 0.0f;
};

struct TanRect {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// The hit of one ray.
struct Seen {
  std::uint32_t object = 0;  // object's index in the scene, and normal: see HitBits; board's index
  float code = 0.0f;         // object: -1/z; sky: 0; ground: 1/z; board: kBoardCode + 1/z  [1/m]
};

/// Above 1/z of the near plane (50 / m), far below the step at which floats lose precision.
inline constexpr float kBoardCode = 64.0f;

inline bool IsObject(float code) { return code < 0.0f; }
inline bool IsBoard(float code) { return code >= kBoardCode; }
inline bool IsSky(float code) { return code == 0.0f; }
/// 1/z of a ray's point; 0 for the sky.
inline float InverseDepth(float code) {
  return code < 0.0f ? -code : code >= kBoardCode ? code - kBoardCode : code;
}

/// How Seen::object holds an index and a normal: two numbers of so many bits for the normal, the
/// rest for the index.
struct HitBits {
  int normal = 12;

  /// Even, so that axes are met exactly.
  int NormalSteps() const { return (1 << normal) - 2; }
  bool operator==(const HitBits&) const = default;
};
inline constexpr int kMaxObjects = 2000;  // eleven bits; a yard of ten square metres has hundreds
inline constexpr HitBits kFewObjects{.normal = 12};   // up to 255; normals within 5e-4 rad
inline constexpr HitBits kManyObjects{.normal = 10};  // up to 4095; within 2e-3 rad
inline HitBits BitsFor(std::size_t objects) { return objects > 255 ? kManyObjects : kFewObjects; }

inline int ObjectOf(const Seen& seen, HitBits bits) {
  return static_cast<int>(seen.object >> (2 * bits.normal));
}
/// Of length 1, in light axes.
Eigen::Vector3f UnpackNormal(const Seen& seen, HitBits bits);

/// Thin bodies before all that, each times its cover: cosine to the sun, cosine to the zenith, 1/z,
/// and 1.
struct Thin {
  float to_sun = 0.0f, to_zenith = 0.0f, inverse_depth = 0.0f, cover = 0.0f;

  void Add(const Thin& thin, float weight) {
    to_sun += weight * thin.to_sun;
    to_zenith += weight * thin.to_zenith;
    inverse_depth += weight * thin.inverse_depth;
    cover += weight * thin.cover;
  }
};

/// One thin body in a part of a view; elsewhere there is none of it.
struct ThinLayer {
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<Thin> thin;
};

/// Rows from the top, rays evenly spread.
struct FlatView {
  TanRect rect;
  int width = 0, height = 0;
  std::vector<Seen> seen;
  std::vector<ThinLayer> layers;  // one for each of the scene's ThinBodies

  bool HasThin() const {
    for (const ThinLayer& layer : layers) {
      if (layer.width > 0) return true;
    }
    return false;
  }
};

}  // namespace dockyard
