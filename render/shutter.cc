#include "render/shutter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr int kMostViews = 16;

void Add(const std::vector<float>& more, std::vector<float>& sum) {
  DOCKYARD_CHECK(more.size() == sum.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
}

void Scale(float factor, std::vector<float>& values) {
  for (float& value : values) value *= factor;
}

}  // namespace

double MotionInExposure_px(const Camera& camera, double turn_rad_s, double speed_m_s,
                           double distance_m, double exposure_s) {
  DOCKYARD_CHECK(distance_m > 0.0);
  return camera.focal_px().maxCoeff() * exposure_s *
         (std::abs(turn_rad_s) + std::abs(speed_m_s) / distance_m);
}

ShutterSteps StepsUnderBlur(double sigma_px) {
  DOCKYARD_CHECK(sigma_px >= 0.0);
  constexpr double kSharp = 0.25 / 0.6, kApart = 1.5;
  const ShutterSteps sharp;
  return {.sharp_px = std::max(sharp.sharp_px, kSharp * sigma_px),
          .step_px = std::max(sharp.step_px, kApart * sigma_px)};
}

// n moments, h apart, have the mean square h^2 (n^2 - 1) / 12.
std::vector<double> ExposureMoments(double motion_px, const ShutterSteps& steps) {
  DOCKYARD_CHECK(std::isfinite(motion_px) && motion_px >= 0.0);
  if (motion_px < steps.sharp_px) return {0.0};
  const double wanted = std::ceil(std::hypot(1.0, motion_px / steps.step_px));
  const int n = static_cast<int>(std::clamp(wanted, 2.0, static_cast<double>(kMostViews)));
  const double apart = 1.0 / std::sqrt(n * n - 1.0);
  std::vector<double> moments;
  for (int i = 0; i < n; ++i) moments.push_back((i - 0.5 * (n - 1)) * apart);
  return moments;
}

std::vector<Pose3> PosesInExposure(const Pose3& X_WC, const Eigen::Vector3d& v_WC_W,
                                   const Eigen::Vector3d& w_WC_W, double exposure_s,
                                   double motion_px, const ShutterSteps& steps) {
  std::vector<Pose3> poses;
  for (const double moment : ExposureMoments(motion_px, steps)) {
    const double after_s = moment * exposure_s;
    Pose3 X = X_WC;
    X.p += after_s * v_WC_W;
    const double turn_rad = after_s * w_WC_W.norm();
    if (turn_rad != 0.0) X.R = Eigen::AngleAxisd(turn_rad, w_WC_W.normalized()) * X_WC.R;
    poses.push_back(X);
  }
  return poses;
}

StereoRadiance OverExposure(double motion_px, const std::function<StereoRadiance(double)>& view) {
  const std::vector<double> moments = ExposureMoments(motion_px);
  StereoRadiance sum = view(moments.front());
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const StereoRadiance more = view(moments[i]);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      Add(more[k].values, sum[k].values);
      Add(more[k].inverse_depth, sum[k].inverse_depth);
    }
  }
  if (moments.size() == 1) return sum;
  const auto share = 1.0f / static_cast<float>(moments.size());
  for (RadianceImage& image : sum) {
    Scale(share, image.values);
    Scale(share, image.inverse_depth);
  }
  return sum;
}

}  // namespace dockyard
