#include "controller/stereo/rectify.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "controller/base/check.h"
#include "controller/stereo/gray_mat.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFar_m = 1e3;
constexpr int kBorderSteps = 64;  // looks along each side of the image

// x along the baseline, z the mean of the views made normal to it.
Eigen::Matrix3d CommonAxes(const StereoRig& rig) {
  const Vector3d baseline = rig.X_RQ.p - rig.X_RL.p;
  if (baseline.norm() < 1e-6) throw std::invalid_argument("a stereo pair needs a baseline");
  const Vector3d x = baseline.normalized();
  const Vector3d view = rig.X_RL.R.col(2) + rig.X_RQ.R.col(2);
  const Vector3d across = view - x * x.dot(view);
  if (across.norm() < 0.5) {
    throw std::invalid_argument("a stereo pair must look across its baseline");
  }
  Eigen::Matrix3d R;
  R.col(0) = x;
  R.col(2) = across.normalized();
  R.col(1) = R.col(2).cross(x);
  return R;
}

constexpr double kSame_px = 0.01;  // less than matching finds; calibrations have 0.1
constexpr int kRaysAlong = 8;      // compared along each side

// How far the camera's pixels lie, at most, from those of a pinhole with the axes of C. [px]
double OffPinhole(const Camera& camera, const Eigen::Matrix3d& R_CK, double focal_px) {
  const Vector2d centre = camera.centre_px();
  double most_px = 0.0;
  for (int j = 0; j <= kRaysAlong; ++j) {
    for (int i = 0; i <= kRaysAlong; ++i) {
      const Vector2d pixel(i * (camera.width - 1.0) / kRaysAlong,
                           j * (camera.height - 1.0) / kRaysAlong);
      const LensRay ray = camera.Ray(pixel);
      const Vector3d along = R_CK * ray.direction;
      if (along.z() <= 0.0 || ray.origin.norm() > 1e-9) return INFINITY;
      const Vector2d ideal = centre + focal_px * along.head<2>() / along.z();
      most_px = std::max(most_px, (pixel - ideal).norm());
    }
  }
  return most_px;
}

}  // namespace

Eigen::Matrix4d ReprojectionOf(const RectifiedPair& pair) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(0, 0) = Q(1, 1) = 1.0;
  Q(0, 3) = -pair.centre_px.x();
  Q(1, 3) = -pair.centre_px.y();
  Q(2, 3) = pair.focal_px;
  Q(3, 2) = 1.0 / pair.baseline_m;
  Q(3, 3) = pair.doffs_px / pair.baseline_m;
  return Q;
}

bool IsRectified(const StereoRig& rig) {
  if (rig.left.width != rig.right.width || rig.left.height != rig.right.height) return false;
  const Eigen::Matrix3d R_CR = rig.X_RL.R.transpose();
  const Vector3d baseline = R_CR * (rig.X_RQ.p - rig.X_RL.p);
  const double focal_px = rig.left.focal_px().x();
  if (!(baseline.x() > 0.0) || focal_px * baseline.tail<2>().norm() > kSame_px * baseline.x()) {
    return false;
  }
  if (std::abs(rig.left.centre_px().y() - rig.right.centre_px().y()) > kSame_px) return false;
  return OffPinhole(rig.left, Eigen::Matrix3d::Identity(), focal_px) <= kSame_px &&
         OffPinhole(rig.right, R_CR * rig.X_RQ.R, focal_px) <= kSame_px;
}

Rectifier::Rectifier(const StereoRig& rig, const RectifySettings& settings)
    : rig_(rig),
      settings_(settings),
      kept_(settings.keep_rectified && settings.focal_px <= 0.0 && IsRectified(rig)) {
  if (kept_) {
    KeepImages();
    return;
  }
  pair_.X_RC = {CommonAxes(rig), rig.X_RL.p};
  pair_.baseline_m = rig.baseline_m();
  pair_.focal_px = settings.focal_px > 0.0 ? settings.focal_px : rig.left.focal_px().x();
  FindBounds();
  left_ = MapOf(false);
  right_ = MapOf(true);
}

// The smallest image that holds what the left camera sees within the widest angle.
void Rectifier::FindBounds() {
  const double most = std::tan(settings_.widest_rad);
  Vector2d low(most, most), high(-most, -most);
  const auto Hold = [&](double u, double v) {
    if (!rig_.left.HasRay({u, v})) return;  // masked: no ray leads there
    const Vector3d ray = pair_.X_RC.R.transpose() * rig_.X_RL.R * rig_.left.Direction({u, v});
    if (ray.z() <= 0.0) return;
    const Vector2d at = (ray.head<2>() / ray.z()).cwiseMax(-most).cwiseMin(most);
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  };
  for (int i = 0; i <= kBorderSteps; ++i) {
    const double u = i * (rig_.left.width - 1.0) / kBorderSteps;
    const double v = i * (rig_.left.height - 1.0) / kBorderSteps;
    Hold(u, 0.0);
    Hold(u, rig_.left.height - 1.0);
    Hold(0.0, v);
    Hold(rig_.left.width - 1.0, v);
  }
  const Vector2d size = pair_.focal_px * (high - low);
  pair_.width = static_cast<int>(std::ceil(size.x())) + 1;
  pair_.height = static_cast<int>(std::ceil(size.y())) + 1;
  pair_.centre_px = -pair_.focal_px * low;
}

void Rectifier::KeepImages() {
  pair_.width = rig_.left.width;
  pair_.height = rig_.left.height;
  pair_.focal_px = rig_.left.focal_px().x();
  pair_.centre_px = rig_.left.centre_px();
  pair_.baseline_m = rig_.baseline_m();
  pair_.X_RC = rig_.X_RL;
  pair_.doffs_px = rig_.right.centre_px().x() - rig_.left.centre_px().x();
  left_ = MapOf(false);
  right_ = MapOf(true);
}

std::optional<Vector2d> Rectifier::Source(const Vector2d& pixel, bool right) const {
  if (kept_) return rig_.left.Sees(pixel) ? std::optional(pixel) : std::nullopt;
  const Camera& camera = right ? rig_.right : rig_.left;
  const Pose3& X_RK = right ? rig_.X_RQ : rig_.X_RL;
  const Vector2d at = (pixel - pair_.centre_px) / pair_.focal_px;
  const Vector3d ray_R = pair_.X_RC.R * Vector3d(at.x(), at.y(), 1.0);
  double along = kFar_m;
  if (settings_.ground_R) {
    const Plane& ground = *settings_.ground_R;
    const double to_ground =
        (ground.offset_m - ground.normal.dot(X_RK.p)) / ground.normal.dot(ray_R);
    if (to_ground > 0.0 && to_ground < kFar_m) along = to_ground;
  }
  const auto source = camera.Project(Inverse(X_RK) * Vector3d(X_RK.p + along * ray_R));
  if (!source || !camera.Sees(*source)) return std::nullopt;
  return source;
}

Rectifier::Map Rectifier::MapOf(bool right) const {
  const auto count = static_cast<std::size_t>(pair_.width) * static_cast<std::size_t>(pair_.height);
  Map map{std::vector<float>(count, -1.0F), std::vector<float>(count, -1.0F)};
  std::size_t place = 0;
  for (int v = 0; v < pair_.height; ++v) {
    for (int u = 0; u < pair_.width; ++u, ++place) {
      const auto source = Source({u, v}, right);
      if (!source) continue;
      map.u[place] = static_cast<float>(source->x());
      map.v[place] = static_cast<float>(source->y());
    }
  }
  return map;
}

bool Rectifier::IsSeen(int u, int v, bool right, int margin_px) const {
  const Map& map = right ? right_ : left_;
  for (const int at_v : {v - margin_px, v + margin_px}) {
    for (const int at_u : {u - margin_px, u + margin_px}) {
      if (at_u < 0 || at_v < 0 || at_u >= pair_.width || at_v >= pair_.height) return false;
      const auto place = static_cast<std::size_t>(at_v) * static_cast<std::size_t>(pair_.width) +
                         static_cast<std::size_t>(at_u);
      if (map.u[place] < 0.0F) return false;
    }
  }
  return true;
}

StereoImages Rectifier::Rectified(const StereoImages& images) const {
  const auto Turned = [&](const GrayImage& image, const Camera& camera, const Map& map) {
    DOCKYARD_CHECK(image.width == camera.width && image.height == camera.height);
    GrayImage out{pair_.width, pair_.height, std::vector<std::uint8_t>(map.u.size())};
    cv::Mat to = MatOn(out);
    const cv::Mat u(pair_.height, pair_.width, CV_32F, const_cast<float*>(map.u.data()));
    const cv::Mat v(pair_.height, pair_.width, CV_32F, const_cast<float*>(map.v.data()));
    cv::remap(MatOn(image), to, u, v, cv::INTER_LINEAR, cv::BORDER_CONSTANT, 0);
    return out;
  };
  return {Turned(images.left, rig_.left, left_), Turned(images.right, rig_.right, right_)};
}

}  // namespace dockyard
