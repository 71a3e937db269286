#include "sim/spectator/viewpoint.h"

#include <Eigen/Geometry>
#include <cmath>

namespace dockyard {
namespace {

// Assumed, for a view in which neither robot nor target hides the other: 30-70 and 15-35 deg.
constexpr double kAside_rad = 50.0 * kPi / 180.0, kAbove_rad = 24.0 * kPi / 180.0;
constexpr double kNearest_m = 0.8, kFarthest_m = 100.0;

bool ShowsAll(const Sights& sights, const Camera& camera, const Pose3& X_WC) {
  const Pose3 X_CW = Inverse(X_WC);
  const auto shows = [&](const Eigen::Vector3d& p_C) {
    const auto pixel = camera.Project(p_C);
    return pixel && camera.Sees(*pixel);
  };
  for (const Eigen::Vector3d& p_W : sights.corners_W) {
    if (!shows(X_CW * p_W)) return false;
  }
  for (const Eigen::Vector3d& p_W : sights.places_W) {
    const Eigen::Vector3d p_C = X_CW * p_W;
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        if (!shows(p_C + sights.margin_m * Eigen::Vector3d(x, 0.8 * y, 0.0))) return false;
      }
    }
  }
  return true;
}

Eigen::Vector3d MiddleOf(const std::vector<Eigen::Vector3d>& places) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places) box.extend(place);
  return box.center();
}

}  // namespace

Camera PinholeCamera(int width, int height, double vertical_fov_rad) {
  BrownPinhole lens;
  lens.fx = lens.fy = 0.5 * height / std::tan(0.5 * vertical_fov_rad);
  lens.cx = 0.5 * (width - 1);
  lens.cy = 0.5 * (height - 1);
  return {.width = width, .height = height, .lens = lens};
}

Pose3 PoseAimedAt(const Eigen::Vector3d& from_W, const Eigen::Vector3d& centre_W) {
  Pose3 X_WC;
  const Eigen::Vector3d z = (centre_W - from_W).normalized();
  const Eigen::Vector3d level = z.cross(Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d x =
      level.norm() > 1e-9 ? Eigen::Vector3d(level.normalized()) : Eigen::Vector3d::UnitX();
  X_WC.R << x, z.cross(x), z;
  X_WC.p = from_W;
  return X_WC;
}

Eigen::Vector3d Direction(double azimuth_rad, double height_rad) {
  return {std::cos(height_rad) * std::cos(azimuth_rad),
          std::cos(height_rad) * std::sin(azimuth_rad), std::sin(height_rad)};
}

Eigen::Vector3d UsualDirection(double heading_rad, const Eigen::Vector3d& to_sun_W) {
  const Eigen::Vector3d left = Direction(heading_rad + kAside_rad, kAbove_rad);
  const Eigen::Vector3d right = Direction(heading_rad - kAside_rad, kAbove_rad);
  const auto lit = [&](const Eigen::Vector3d& out) {
    return out.head<2>().dot(to_sun_W.head<2>());
  };
  return lit(right) > lit(left) ? right : left;
}

Pose3 SpectatorPose(const Sights& sights, const Camera& camera,
                    const std::optional<Eigen::Vector3d>& from_D) {
  const Eigen::Vector3d middle_W = MiddleOf(sights.places_W);
  if (from_D) return PoseAimedAt(FromGround(sights.X_WD, 0.0) * *from_D, middle_W);
  const Eigen::Vector3d out = UsualDirection(sights.X_WD.heading, sights.to_sun_W);
  double distance_m = kNearest_m;
  while (distance_m < kFarthest_m &&
         !ShowsAll(sights, camera, PoseAimedAt(middle_W + distance_m * out, middle_W))) {
    distance_m *= 1.03;
  }
  return PoseAimedAt(middle_W + distance_m * out, middle_W);
}

}  // namespace dockyard
