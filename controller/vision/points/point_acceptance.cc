#include "controller/vision/points/point_acceptance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr std::size_t kMinPoints = 4;  // three fix a pose and agree with any
// The median of all errors is the scale of their noise only while less than half are wrong
// (Rousseeuw, Journal of the American Statistical Association 79, 1984).
constexpr double kLeastShare = 0.5;
// One pose in a hundred frames whose names are all wrong. Assumed, 0.001-0.1.
constexpr double kMostAccidents = 0.01;

// Beyond these the linear covariance means nothing: 30 deg, and this share of the distance.
// Assumed, 15-45 deg and 0.2-0.7.
constexpr double kMostTurnSigma_rad = kPi / 6.0, kMostPlaceSigma = 0.5;

/// Chance that at least `least` of n independent events of probability p happen.
double AtLeast(std::size_t least, std::size_t n, double p) {
  if (least == 0 || p >= 1.0) return 1.0;
  if (!(p > 0.0)) return 0.0;
  const auto log_factorial = [](std::size_t k) {
    return std::lgamma(static_cast<double>(k) + 1.0);
  };
  double sum = 0.0;
  for (std::size_t k = least; k <= n; ++k) {
    sum += std::exp(log_factorial(n) - log_factorial(k) - log_factorial(n - k) +
                    static_cast<double>(k) * std::log(p) +
                    static_cast<double>(n - k) * std::log1p(-p));
  }
  return std::min(sum, 1.0);
}

double AccidentsInView(const std::vector<PointPixel>& points, const std::vector<bool>& inlier,
                       const std::vector<double>& error_px, int view) {
  std::vector<bool> seen(points.size());
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
  double radius_px = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    seen[i] = points[i].view == view;
    if (!seen[i]) continue;
    low = low.cwiseMin(points[i].pixel);
    high = high.cwiseMax(points[i].pixel);
    if (inlier[i]) radius_px = std::max(radius_px, error_px[i]);
  }
  const std::size_t n = DistinctPoints(points, seen), k = DistinctPoints(points, inlier, view);
  if (k < 3) return 1e9;
  const Eigen::Vector2d size = (high - low).cwiseMax(1.0);
  const double p = std::min(1.0, kPi * radius_px * radius_px / (size.x() * size.y()));
  const double count = static_cast<double>(n);
  const double triples = count * (count - 1.0) * (count - 2.0) / 6.0;
  return 4.0 * triples * AtLeast(k - 3, n - 3, p);
}

bool IsSound(const RefinedPose& fit, const std::vector<PointPixel>& points,
             const std::vector<bool>& inlier, const std::vector<CameraView>& views) {
  if (!fit.covariance.allFinite()) return false;
  const Eigen::LLT<Matrix6d> root(fit.covariance);
  if (root.info() != Eigen::Success) return false;
  if (fit.covariance.bottomRightCorner<3, 3>().diagonal().maxCoeff() >
      kMostTurnSigma_rad * kMostTurnSigma_rad) {
    return false;
  }
  // Where the points are, not where the body's origin is: that may be far from them.
  Eigen::Vector3d centre_R = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!inlier[i]) continue;
    centre_R += fit.X_RB * points[i].p_B;
    count += 1.0;
  }
  centre_R /= count;
  const Eigen::Vector3d arm = centre_R - fit.X_RB.p;
  Eigen::Matrix<double, 3, 6> of_centre;
  of_centre << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  of_centre.rightCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
  const Eigen::Matrix3d place = of_centre * fit.covariance * of_centre.transpose();
  const double distance = (centre_R - views[0].X_RC.p).norm();
  return std::sqrt(place.diagonal().maxCoeff()) < kMostPlaceSigma * distance;
}

}  // namespace

std::size_t DistinctPoints(const std::vector<PointPixel>& points, const std::vector<bool>& chosen,
                           int view) {
  std::vector<Eigen::Vector3d> known;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!chosen[i] || (view >= 0 && points[i].view != view)) continue;
    if (std::find(known.begin(), known.end(), points[i].p_B) == known.end()) {
      known.push_back(points[i].p_B);
    }
  }
  return known.size();
}

double ExpectedAccidents(const std::vector<PointPixel>& points, const std::vector<bool>& inlier,
                         const std::vector<double>& error_px) {
  return std::min(AccidentsInView(points, inlier, error_px, 0),
                  AccidentsInView(points, inlier, error_px, 1));
}

std::optional<PoseFailure> JudgePoints(const std::vector<PointPixel>& points,
                                       const std::vector<bool>& inlier,
                                       const std::vector<double>& error_px,
                                       const std::vector<CameraView>& views,
                                       const RefinedPose& fit) {
  const std::vector<bool> all(points.size(), true);
  const auto share = [&](int view) {
    const double n = static_cast<double>(DistinctPoints(points, all, view));
    return n > 0.0 ? static_cast<double>(DistinctPoints(points, inlier, view)) / n : 0.0;
  };
  if (DistinctPoints(points, inlier) < kMinPoints) return PoseFailure::kTooFewFiducials;
  if (share(-1) < kLeastShare) return PoseFailure::kNoCorrespondence;
  for (int view = 0; view < 2; ++view) {
    const bool enough = DistinctPoints(points, all, view) >= kMinPoints;
    if (enough && share(view) < kLeastShare) return PoseFailure::kCamerasDisagree;
  }
  if (ExpectedAccidents(points, inlier, error_px) > kMostAccidents) {
    return PoseFailure::kNoCorrespondence;
  }
  if (!IsSound(fit, points, inlier, views)) return PoseFailure::kUncertain;
  return std::nullopt;
}

}  // namespace dockyard
