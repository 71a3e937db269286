#include "controller/vision/homography.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

/// Similarity that moves points to mean zero and mean distance sqrt(2).
Eigen::Matrix3d Normaliser(const std::vector<PlanePair>& pairs, Eigen::Vector2d PlanePair::*side) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const PlanePair& pair : pairs) mean += pair.*side;
  mean /= static_cast<double>(pairs.size());
  double distance = 0.0;
  for (const PlanePair& pair : pairs) distance += (pair.*side - mean).norm();
  const double scale = std::sqrt(2.0) * static_cast<double>(pairs.size()) / distance;
  Eigen::Matrix3d N;
  N << scale, 0.0, -scale * mean.x(), 0.0, scale, -scale * mean.y(), 0.0, 0.0, 1.0;
  return N;
}

struct Fit {
  Eigen::Matrix3d H;
  double worst = 0.0, rms = 0.0;
};

std::optional<Fit> FitWithErrors(const std::vector<PlanePair>& pairs) {
  const std::optional<Eigen::Matrix3d> H = FitHomography(pairs);
  if (!H) return std::nullopt;
  Fit fit{.H = *H};
  double sum = 0.0;
  for (const PlanePair& pair : pairs) {
    const std::optional<Eigen::Vector2d> mapped = Map(*H, pair.board);
    if (!mapped) return std::nullopt;
    const double squared = (*mapped - pair.image).squaredNorm();
    sum += squared;
    fit.worst = std::max(fit.worst, std::sqrt(squared));
  }
  fit.rms = std::sqrt(sum / static_cast<double>(pairs.size()));
  return fit;
}

}  // namespace

Eigen::Vector2d TangentPlane::FromRay(const Eigen::Vector3d& ray_C) const {
  const Eigen::Vector3d ray_T = R_TC * ray_C;
  return ray_T.head<2>() / std::max(ray_T.z(), 0.05);
}

Eigen::Vector3d TangentPlane::ToRay(const Eigen::Vector2d& point_T) const {
  return R_TC.transpose() * Eigen::Vector3d(point_T.x(), point_T.y(), 1.0).normalized();
}

TangentPlane TangentPlaneAt(const std::vector<Eigen::Vector3d>& rays_C) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& ray : rays_C) mean += ray;
  if (mean.norm() < 1e-6) mean = Eigen::Vector3d::UnitZ();
  return {RotationBetween(mean, Eigen::Vector3d::UnitZ())};
}

std::optional<Eigen::Matrix3d> FitHomography(const std::vector<PlanePair>& pairs) {
  if (pairs.size() < 4) return std::nullopt;
  const Eigen::Matrix3d Nb = Normaliser(pairs, &PlanePair::board);
  const Eigen::Matrix3d Ni = Normaliser(pairs, &PlanePair::image);
  if (!Nb.allFinite() || !Ni.allFinite()) return std::nullopt;
  // The middle of the points lies before the camera, so the last element may be set to one.
  Eigen::Matrix<double, 8, 8> AtA = Eigen::Matrix<double, 8, 8>::Zero();
  Eigen::Matrix<double, 8, 1> Atb = Eigen::Matrix<double, 8, 1>::Zero();
  for (const PlanePair& pair : pairs) {
    const Eigen::Vector3d b = Nb * pair.board.homogeneous();
    const Eigen::Vector3d m = Ni * pair.image.homogeneous();
    Eigen::Matrix<double, 8, 1> row_u, row_v;
    row_u << b.x(), b.y(), 1, 0, 0, 0, -m.x() * b.x(), -m.x() * b.y();
    row_v << 0, 0, 0, b.x(), b.y(), 1, -m.y() * b.x(), -m.y() * b.y();
    AtA.noalias() += row_u * row_u.transpose() + row_v * row_v.transpose();
    Atb += row_u * m.x() + row_v * m.y();
  }
  const Eigen::LDLT<Eigen::Matrix<double, 8, 8>> ldlt(AtA);
  if (!(ldlt.vectorD().minCoeff() > 1e-12 * ldlt.vectorD().maxCoeff())) return std::nullopt;
  const Eigen::Matrix<double, 8, 1> h = ldlt.solve(Atb);
  Eigen::Matrix3d H;
  H << h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), 1.0;
  return Ni.inverse() * H * Nb;
}

std::optional<Eigen::Vector2d> Map(const Eigen::Matrix3d& H, const Eigen::Vector2d& board) {
  const Eigen::Vector3d mapped = H * board.homogeneous();
  if (!(mapped.z() * H(2, 2) > 1e-6 * H(2, 2) * H(2, 2))) return std::nullopt;
  return mapped.hnormalized();
}

std::optional<RobustHomography> FitHomographyRobust(const std::vector<PlanePair>& pairs,
                                                    double gate, int min_inliers) {
  std::vector<std::size_t> kept(pairs.size());
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = i;
  std::vector<PlanePair> chosen = pairs;
  std::optional<Fit> fit = FitWithErrors(chosen);
  while (!fit || fit->worst > gate) {
    if (static_cast<int>(kept.size()) <= min_inliers) return std::nullopt;
    std::optional<Fit> best;
    std::size_t best_out = 0;
    for (std::size_t out = 0; out < kept.size(); ++out) {
      std::vector<PlanePair> rest = chosen;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(out));
      const std::optional<Fit> without = FitWithErrors(rest);
      if (!without || (best && without->rms >= best->rms)) continue;
      best = without;
      best_out = out;
    }
    if (!best) return std::nullopt;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(best_out));
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(best_out));
    fit = best;
  }
  if (static_cast<int>(kept.size()) < min_inliers) return std::nullopt;
  RobustHomography robust{.H = fit->H, .inlier = {}, .rms = fit->rms};
  robust.inlier.assign(pairs.size(), false);
  for (const std::size_t i : kept) robust.inlier[i] = true;
  return robust;
}

}  // namespace dockyard
