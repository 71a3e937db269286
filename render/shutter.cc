#include "render/shutter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr int kMostViews = 16;
// Up to here a blurred edge is that of a box to 0.5 % of its step, under a lens of 0.6 px:
// MotionBlur.EdgeIsThatOfABoxUnderTheLens.
constexpr double kPart_px = 0.85;

void Add(const std::vector<float>& more, std::vector<float>& sum) {
  DOCKYARD_CHECK(more.size() == sum.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
}

void Add(RadianceImage more, RadianceImage& sum) {
  if (sum.values.empty()) {
    sum = std::move(more);
    return;
  }
  Add(more.values, sum.values);
  Add(more.inverse_depth, sum.inverse_depth);
}

void Scale(float factor, RadianceImage& image) {
  if (factor == 1.0f) return;
  for (float& value : image.values) value *= factor;
  for (float& value : image.inverse_depth) value *= factor;
}

/// Of cameras at X_BC on a body that moves so.
template <std::size_t kCount, typename View>
std::array<RadianceImage, kCount> Mean(double motion_px,
                                       const std::array<const Camera*, kCount>& cameras,
                                       const std::array<Pose3, kCount>& X_BC,
                                       const ExposureMotion& body, const View& view) {
  DOCKYARD_CHECK(std::isfinite(motion_px) && motion_px >= 0.0);
  if (motion_px < ShutterSteps{}.sharp_px) return view(0.0, false);
  const double wanted = std::ceil(motion_px / kPart_px);
  const int parts = static_cast<int>(std::min(wanted, static_cast<double>(kMostViews)));
  const ExposureMotion part{body.shift_m / parts, body.turn_rad / parts};
  std::array<RadianceImage, kCount> sum;
  for (int i = 0; i < parts; ++i) {
    std::array<RadianceImage, kCount> more = view((i + 0.5) / parts - 0.5, true);
    for (std::size_t k = 0; k < kCount; ++k) {
      BlurByMotion(*cameras[k], MotionOfCamera(part, X_BC[k]), more[k]);
      Add(std::move(more[k]), sum[k]);
    }
  }
  for (RadianceImage& image : sum) Scale(1.0f / static_cast<float>(parts), image);
  return sum;
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

Pose3 MovedOn(const Pose3& X_WB, const Eigen::Vector3d& v_WB_W, const Eigen::Vector3d& w_WB_W,
              double seconds) {
  Pose3 X = X_WB;
  X.p += seconds * v_WB_W;
  const double turn_rad = seconds * w_WB_W.norm();
  if (turn_rad != 0.0) X.R = Eigen::AngleAxisd(turn_rad, w_WB_W.normalized()) * X_WB.R;
  return X;
}

std::vector<Pose3> PosesInExposure(const Pose3& X_WC, const Eigen::Vector3d& v_WC_W,
                                   const Eigen::Vector3d& w_WC_W, double exposure_s,
                                   double motion_px, const ShutterSteps& steps) {
  std::vector<Pose3> poses;
  for (const double moment : ExposureMoments(motion_px, steps)) {
    poses.push_back(MovedOn(X_WC, v_WC_W, w_WC_W, moment * exposure_s));
  }
  return poses;
}

StereoRadiance OverExposure(double motion_px, const StereoRig& rig, const ExposureMotion& motion,
                            const ViewAt& view) {
  return Mean<2>(motion_px, {&rig.left, &rig.right}, {rig.X_RL, rig.X_RQ}, motion, view);
}

RadianceImage OverExposure(double motion_px, const Camera& camera, const ExposureMotion& motion,
                           const OneViewAt& view) {
  return std::move(Mean<1>(motion_px, {&camera}, {Pose3{}}, motion,
                           [&](double share, bool with_depth) -> std::array<RadianceImage, 1> {
                             return {view(share, with_depth)};
                           })[0]);
}

}  // namespace dockyard
