#include "controller/stereo/face_plane.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/base/median.h"

namespace dockyard {
namespace {

constexpr int kFaceRounds = 6;
// Disparities of pixels that share a block err together. Assumed, 9-49: a block of 3 to 7 px.
constexpr double kAlike = 25.0;
// A disparity's own error, at least. Assumed, 0.1-0.3 px.
constexpr double kLeastOff_px = 0.15;

struct FacePixel {
  double u = 0.0, v = 0.0, disparity_px = 0.0;  // u, v from the pixel that is asked for
};

std::vector<FacePixel> PixelsAbout(const Disparities& disparities, const Eigen::Vector2d& pixel,
                                   double radius_px) {
  std::vector<FacePixel> found;
  const int reach = static_cast<int>(std::ceil(radius_px));
  const int u0 = static_cast<int>(std::lround(pixel.x()));
  const int v0 = static_cast<int>(std::lround(pixel.y()));
  for (int v = std::max(0, v0 - reach); v <= std::min(disparities.height - 1, v0 + reach); ++v) {
    for (int u = std::max(0, u0 - reach); u <= std::min(disparities.width - 1, u0 + reach); ++u) {
      const double disparity_px = disparities.at(u, v);
      const FacePixel at{u - pixel.x(), v - pixel.y(), disparity_px};
      if (disparity_px > 0.0 && std::hypot(at.u, at.v) <= radius_px) found.push_back(at);
    }
  }
  return found;
}

// Weighted least squares of a + b u + c v, each point by Tukey's weight about the last fit.
Eigen::Vector3d FitOnce(const std::vector<FacePixel>& points, const Eigen::Vector3d& before,
                        double scale_px, Eigen::Matrix3d* normal_matrix, int* used) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  *used = 0;
  for (const FacePixel& point : points) {
    const Eigen::Vector3d row(1.0, point.u, point.v);
    const double off = (point.disparity_px - row.dot(before)) / scale_px;
    if (std::abs(off) >= 1.0) continue;
    const double weight = (1.0 - off * off) * (1.0 - off * off);
    A += weight * row * row.transpose();
    b += weight * point.disparity_px * row;
    ++*used;
  }
  *normal_matrix = A;
  return *used < 3 ? before : Eigen::Vector3d(A.ldlt().solve(b));
}

// Those whose place on the plane is so near the point under the pixel: a slope is seen shortened.
std::vector<FacePixel> OnPlaneWithin(const RectifiedPair& pair, const Eigen::Vector2d& pixel,
                                     const std::vector<FacePixel>& points,
                                     const Eigen::Vector3d& fit, double radius_m) {
  const auto place = [&](double u, double v) {
    const double disparity_px = std::max(1e-3, fit.dot(Eigen::Vector3d(1.0, u, v)));
    return pair.Point(pixel.x() + u, pixel.y() + v, disparity_px);
  };
  const Eigen::Vector3d middle = place(0.0, 0.0);
  std::vector<FacePixel> within;
  for (const FacePixel& point : points) {
    if ((place(point.u, point.v) - middle).norm() <= radius_m) within.push_back(point);
  }
  return within;
}

}  // namespace

std::optional<Eigen::Vector3d> PointUnder(const RectifiedPair& pair, const Disparities& disparities,
                                          const Eigen::Vector2d& pixel, int beside_px) {
  std::vector<double> near;
  for (const FacePixel& at : PixelsAbout(disparities, pixel, 1.5 * beside_px)) {
    near.push_back(at.disparity_px);
  }
  if (near.empty()) return std::nullopt;
  return pair.Point(pixel.x(), pixel.y(), Median(near));
}

std::optional<FacePlane> PlaneUnder(const RectifiedPair& pair, const Disparities& disparities,
                                    const Eigen::Vector2d& pixel,
                                    const FacePlaneSettings& settings) {
  const auto p_C = PointUnder(pair, disparities, pixel);
  if (!p_C) return std::nullopt;
  const double least_px = settings.least_px;
  const double radius_px =
      std::max(least_px, pair.focal_px * settings.radius_m / std::max(0.05, p_C->z()));
  const std::vector<FacePixel> seen = PixelsAbout(disparities, pixel, radius_px);
  if (static_cast<int>(seen.size()) < settings.least_points) return std::nullopt;
  // From wide to narrow: the first rounds let a slope in, the last ones leave edges out.
  std::vector<double> all;
  for (const FacePixel& point : seen) all.push_back(point.disparity_px);
  Eigen::Vector3d fit(Median(all), 0.0, 0.0);
  const double slope_px =
      0.5 * (*std::max_element(all.begin(), all.end()) - *std::min_element(all.begin(), all.end()));
  Eigen::Matrix3d A;
  int used = 0;
  std::vector<FacePixel> points = seen;
  for (int round = 0; round < kFaceRounds; ++round) {
    const double widen = std::pow(0.5, round) * std::min(slope_px, 0.5 * radius_px);
    fit = FitOnce(points, fit, 2.0 * settings.most_off_px + 2.0 * widen, &A, &used);
    points = OnPlaneWithin(pair, pixel, seen, fit, radius_px / pair.focal_px * p_C->z());
  }
  if (used < settings.least_points || fit[0] <= 0.0) return std::nullopt;
  double sum = 0.0;
  int counted = 0;
  for (const FacePixel& point : points) {
    const double off = point.disparity_px - fit.dot(Eigen::Vector3d(1.0, point.u, point.v));
    if (std::abs(off) > settings.most_off_px) continue;
    sum += off * off;
    ++counted;
  }
  if (counted < settings.least_points) return std::nullopt;
  // d = scaled . (u - cu, v - cv, f), where scaled . p = baseline holds on the plane.
  const Eigen::Vector2d from = pixel - pair.centre_px;
  const Eigen::Vector3d scaled(fit[1], fit[2],
                               (fit[0] - fit[1] * from.x() - fit[2] * from.y()) / pair.focal_px);
  FacePlane plane;
  plane.p = pair.X_RC * pair.Point(pixel.x(), pixel.y(), fit[0]);
  plane.normal = -(pair.X_RC.R * scaled.normalized());
  plane.points = counted;
  plane.off_px = std::sqrt(sum / counted);
  const double sigma_px = std::max(kLeastOff_px, plane.off_px);
  const Eigen::Matrix3d covariance = sigma_px * sigma_px * kAlike * A.inverse();
  const double slope_sigma = std::sqrt(std::max(covariance(1, 1), covariance(2, 2)));
  plane.normal_sigma_rad = slope_sigma / scaled.norm();
  return plane;
}

}  // namespace dockyard
