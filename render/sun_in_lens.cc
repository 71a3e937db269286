#include "render/sun_in_lens.h"

#include <Eigen/Geometry>
#include <cmath>

#include "render/view_sampler.h"

namespace dockyard {
namespace {

constexpr int kSunRays = 40;  // a side: a share is exact to some 1 / 40 / 40 of the disc

Pose3 FacingAlong(const Pose3& X_WC, const Eigen::Vector3d& to_W) {
  Pose3 X_WS;
  X_WS.R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), to_W).toRotationMatrix();
  X_WS.p = X_WC.p;
  return X_WS;
}

double FreeShare(const FlatView& view, double radius) {
  const ViewSampler sampler(view);
  double free = 0.0, all = 0.0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const auto at = [&](double from, double to, int i, int count) {
        return static_cast<float>(from + (to - from) * (i + 0.5) / count);
      };
      const Tan tan{at(view.rect.left, view.rect.right, x, view.width),
                    at(view.rect.top, view.rect.bottom, y, view.height)};
      if (std::hypot(tan.x, tan.y) > radius) continue;
      ++all;
      if (!IsSky(sampler.At(tan).code)) continue;
      double clear = 1.0;
      for (const ThinLayer& layer : view.layers) {
        if (layer.width > 0) clear *= 1.0 - std::min(1.0f, sampler.ThinAt(layer, tan).cover);
      }
      free += clear;
    }
  }
  return all > 0.0 ? free / all : 0.0;
}

}  // namespace

SunInLens SunSight::Of(ScenePainter& painter, const Scene& scene, const Pose3& X_WC) {
  constexpr double kPoint_rad = 1e-4;  // a sun without an extent
  const double radius = std::max(0.5 * scene.light.sun_angular_diameter_rad, kPoint_rad);
  SunInLens sun{.to_sun_C = X_WC.R.transpose() * scene.light.to_sun_W, .radius_rad = radius};
  if (scene.light.sun_irradiance <= 0.0 || sun.to_sun_C.z() <= 0.0) return sun;
  const double edge = std::tan(radius);
  view_.rect = {-edge, -edge, edge, edge};
  view_.width = view_.height = kSunRays;
  painter.PaintInto(target_, FacingAlong(X_WC, scene.light.to_sun_W), view_);
  sun.share = FreeShare(view_, edge);
  return sun;
}

}  // namespace dockyard
