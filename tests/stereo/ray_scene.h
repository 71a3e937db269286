// Stereo pairs of a scene that is known in closed form, ray by ray and without the renderer: level
// ground with a round stone in it, both of them with a texture that belongs to the place.
#pragma once

#include <cmath>
#include <cstdint>

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "sim/base/hash.h"

namespace dockyard {

/// z up, the ground at z = 0, the rig's frame at its origin.
struct RayScene {
  Eigen::Vector3d stone{0.0, 0.0, -1.0};  // centre of a ball
  double stone_radius_m = 0.0;
  double grain_m = 0.004;

  /// Height of the surface at a place.
  double Height(double x, double y) const {
    const double r2 = (Eigen::Vector2d(x, y) - stone.head<2>()).squaredNorm();
    const double rest = stone_radius_m * stone_radius_m - r2;
    return rest <= 0.0 ? 0.0 : std::max(0.0, stone.z() + std::sqrt(rest));
  }

  /// Smooth noise, 0 to 1.
  double Texture(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d at = p / grain_m;
    const Eigen::Vector3d low = at.array().floor();
    const Eigen::Vector3d t = at - low;
    // Corners share the hash of the coordinates that they share: a picture asks a million times.
    std::uint64_t hashes[8];
    for (int x = 0; x < 2; ++x) {
      const std::uint64_t of_x = HashDouble(17, low.x() + x);
      for (int y = 0; y < 2; ++y) {
        const std::uint64_t of_xy = HashDouble(of_x, low.y() + y);
        for (int z = 0; z < 2; ++z) hashes[x + 2 * y + 4 * z] = HashDouble(of_xy, low.z() + z);
      }
    }
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1.0;
      for (int i = 0; i < 3; ++i) weight *= corner >> i & 1 ? t[i] : 1.0 - t[i];
      sum += weight * static_cast<double>(hashes[corner] >> 40) / static_cast<double>(1U << 24);
    }
    return sum;
  }

  /// What a ray meets; far away for the sky.
  Eigen::Vector3d Hit(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
    const Eigen::Vector3d to = from - stone;
    const double b = to.dot(along), c = to.squaredNorm() - stone_radius_m * stone_radius_m;
    if (b * b > c && stone_radius_m > 0.0) {
      const Eigen::Vector3d p = from + (-b - std::sqrt(b * b - c)) * along;
      if (p.z() > 0.0) return p;
    }
    const double way = along.z() < 0.0 ? -from.z() / along.z() : 1e3;
    return from + std::min(way, 1e3) * along;
  }

  GrayImage Picture(const Camera& camera, const Pose3& X_RC) const {
    GrayImage image{camera.width, camera.height, {}};
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        // Four rays a pixel, as a pixel is an area.
        double sum = 0.0;
        for (const double dv : {-0.25, 0.25}) {
          for (const double du : {-0.25, 0.25}) {
            const Eigen::Vector3d along = X_RC.R * camera.Direction({u + du, v + dv});
            sum += Texture(Hit(X_RC.p, along));
          }
        }
        image.pixels.push_back(static_cast<std::uint8_t>(40.0 + 160.0 * 0.25 * sum));
      }
    }
    return image;
  }
  StereoImages Pair(const StereoRig& rig) const {
    return {Picture(rig.left, rig.X_RL), Picture(rig.right, rig.X_RQ)};
  }
};

/// A camera pose: looking ahead and down, at a place.
inline Pose3 LookingDown(const Eigen::Vector3d& p, double down_rad) {
  // Camera z ahead, x to the right, y down, before it is tipped.
  Eigen::Matrix3d R;
  R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {RotY(down_rad) * R, p};
}

/// Rocky 7's body pair: 0.3 m up, 45 deg down (Nesnas et al. 2000); half the size, to be quick.
inline StereoRig BodyPair() {
  const Camera camera = EquidistantCamera(320, 240, Radians(95.0));
  return {camera, camera, LookingDown({0.0, 0.05, 0.3}, Radians(45.0)),
          LookingDown({0.0, -0.05, 0.3}, Radians(45.0))};
}

}  // namespace dockyard
