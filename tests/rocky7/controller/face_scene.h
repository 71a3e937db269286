// A flat face with a texture that belongs to it, before level ground, as the mast's cameras see it:
// pictures by casting rays, with noise.
#pragma once

#include <cmath>

#include "controller/rocky7/mast.h"
#include "rocky7/controller/nominal_rover.h"
#include "sim/base/hash.h"
#include "stereo/ray_scene.h"

namespace dockyard::rocky7 {

/// Frame W: on the ground, z up.
struct FaceScene {
  Eigen::Vector3d p_W{0, 0, 0}, normal_W{-1, 0, 0};
  double radius_m = 0.35;
  double other = 0.0;  // another number, another texture

  double Grey(const Eigen::Vector3d& at) const {
    // Turned, lest the noise's lattice shows as stripes on a face.
    static const Eigen::Matrix3d turn = RotZ(0.7) * RotX(0.5) * RotY(0.3);
    const Eigen::Vector3d turned = turn * at + Eigen::Vector3d(other, 3, 0);
    double sum = 0.0;
    for (const double grain_m : {0.01, 0.05}) sum += RayScene{.grain_m = grain_m}.Texture(turned);
    return 30.0 + 90.0 * sum;
  }

  Eigen::Vector3d Hit(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
    const double way = normal_W.dot(p_W - from) / normal_W.dot(along);
    const Eigen::Vector3d at = from + way * along;
    if (way > 0.0 && (at - p_W).norm() < radius_m) return at;
    return RayScene{}.Hit(from, along);
  }

  GrayImage Picture(const Camera& camera, const Pose3& X_WC) const {
    GrayImage image{camera.width, camera.height, {}};
    for (int v = 0; v < camera.height; ++v) {
      for (int u = 0; u < camera.width; ++u) {
        // Two rays a pixel, as a pixel is an area.
        double sum = 0.0;
        for (const double d : {-0.25, 0.25}) {
          sum += Grey(Hit(X_WC.p, X_WC.R * camera.Direction({u + d, v - d})));
        }
        const std::uint64_t hash = HashDouble(HashDouble(11, u + 1e-3 * v), X_WC.p.x());
        const double noise = static_cast<double>(hash >> 40) / static_cast<double>(1U << 24) - 0.5;
        const double grey = 0.5 * sum + 6.0 * noise;
        image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0)));
      }
    }
    return image;
  }

  /// The pair's pictures with R at a pose over the ground.
  StereoImages Pair(const Nominal& nominal, const Pose2& X_WE, const MastAngles& angles) const {
    const Pose3 X_WR = FromGround(X_WE, nominal.rolling_radius_m);
    const Pose3 X_WK = X_WR * SecondLink(nominal.mast, angles);
    const StereoRig& rig = nominal.mast.pair_K;
    return {Picture(rig.left, X_WK * rig.X_RL), Picture(rig.right, X_WK * rig.X_RQ)};
  }

  /// A place of W in E, and a direction.
  static Eigen::Vector3d InE(const Pose2& X_WE, const Eigen::Vector3d& p_W) {
    return Inverse(FromGround(X_WE, 0.0)) * p_W;
  }
  static Eigen::Vector3d TurnedInE(const Pose2& X_WE, const Eigen::Vector3d& direction_W) {
    return RotZ(-X_WE.heading) * direction_W;
  }
};

/// A face's outward normal towards the rover: raised by so much, turned aside.
inline Eigen::Vector3d NormalOf(double up_deg, double aside_deg) {
  return RotZ(Radians(aside_deg)) *
         Eigen::Vector3d(-std::cos(Radians(up_deg)), 0.0, std::sin(Radians(up_deg)));
}

}  // namespace dockyard::rocky7
