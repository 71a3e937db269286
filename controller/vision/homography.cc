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

using Matrix8 = Eigen::Matrix<double, 8, 8>;
using Vector8 = Eigen::Matrix<double, 8, 1>;

/// Normal equations of the homography of normalised points; those of fewer points follow by
/// subtraction.
struct Equations {
  Matrix8 A = Matrix8::Zero();
  Vector8 b = Vector8::Zero();
};

Equations EquationsOf(const PlanePair& pair, const Eigen::Matrix3d& Nb, const Eigen::Matrix3d& Ni) {
  const Eigen::Vector3d b = Nb * pair.board.homogeneous();
  const Eigen::Vector3d m = Ni * pair.image.homogeneous();
  // The middle of the points lies before the camera, so the last element may be set to one.
  Vector8 row_u, row_v;
  row_u << b.x(), b.y(), 1, 0, 0, 0, -m.x() * b.x(), -m.x() * b.y();
  row_v << 0, 0, 0, b.x(), b.y(), 1, -m.y() * b.x(), -m.y() * b.y();
  Equations of;
  of.A.noalias() = row_u * row_u.transpose() + row_v * row_v.transpose();
  of.b = row_u * m.x() + row_v * m.y();
  return of;
}

std::optional<Eigen::Matrix3d> Solve(const Equations& all, const Eigen::Matrix3d& Nb,
                                     const Eigen::Matrix3d& Ni_inverse) {
  const Eigen::LDLT<Matrix8> ldlt(all.A);
  if (!(ldlt.vectorD().minCoeff() > 1e-12 * ldlt.vectorD().maxCoeff())) return std::nullopt;
  const Vector8 h = ldlt.solve(all.b);
  Eigen::Matrix3d H;
  H << h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), 1.0;
  return Ni_inverse * H * Nb;
}

struct Fit {
  Eigen::Matrix3d H;
  double worst = 0.0, rms = 0.0;
};

/// Errors of the pairs that are kept; none when one goes to infinity.
std::optional<Fit> WithErrors(const std::optional<Eigen::Matrix3d>& H,
                              const std::vector<PlanePair>& pairs, const std::vector<bool>& kept,
                              std::size_t without) {
  if (!H) return std::nullopt;
  Fit fit{.H = *H};
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!kept[i] || i == without) continue;
    const std::optional<Eigen::Vector2d> mapped = Map(*H, pairs[i].board);
    if (!mapped) return std::nullopt;
    const double squared = (*mapped - pairs[i].image).squaredNorm();
    sum += squared;
    ++count;
    fit.worst = std::max(fit.worst, std::sqrt(squared));
  }
  fit.rms = std::sqrt(sum / count);
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
  Equations all;
  for (const PlanePair& pair : pairs) {
    const Equations of = EquationsOf(pair, Nb, Ni);
    all.A += of.A;
    all.b += of.b;
  }
  return Solve(all, Nb, Ni.inverse());
}

std::optional<Eigen::Vector2d> Map(const Eigen::Matrix3d& H, const Eigen::Vector2d& board) {
  const Eigen::Vector3d mapped = H * board.homogeneous();
  if (!(mapped.z() * H(2, 2) > 1e-6 * H(2, 2) * H(2, 2))) return std::nullopt;
  return mapped.hnormalized();
}

std::optional<RobustHomography> FitHomographyRobust(const std::vector<PlanePair>& pairs,
                                                    double gate, int min_inliers) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  int count = static_cast<int>(pairs.size());
  if (count < std::max(min_inliers, 4)) return std::nullopt;
  const Eigen::Matrix3d Nb = Normaliser(pairs, &PlanePair::board);
  const Eigen::Matrix3d Ni = Normaliser(pairs, &PlanePair::image);
  if (!Nb.allFinite() || !Ni.allFinite()) return std::nullopt;
  const Eigen::Matrix3d Ni_inverse = Ni.inverse();
  std::vector<Equations> each;
  Equations all;
  for (const PlanePair& pair : pairs) {
    each.push_back(EquationsOf(pair, Nb, Ni));
    all.A += each.back().A;
    all.b += each.back().b;
  }
  std::vector<bool> kept(pairs.size(), true);
  std::optional<Fit> fit = WithErrors(Solve(all, Nb, Ni_inverse), pairs, kept, kNone);
  while (!fit || fit->worst > gate) {
    if (count <= std::max(min_inliers, 4)) return std::nullopt;
    std::optional<Fit> best;
    std::size_t best_out = 0;
    for (std::size_t out = 0; out < pairs.size(); ++out) {
      if (!kept[out]) continue;
      const Equations rest{.A = all.A - each[out].A, .b = all.b - each[out].b};
      const auto without = WithErrors(Solve(rest, Nb, Ni_inverse), pairs, kept, out);
      if (!without || (best && without->rms >= best->rms)) continue;
      best = without;
      best_out = out;
    }
    if (!best) return std::nullopt;
    kept[best_out] = false;
    --count;
    all.A -= each[best_out].A;
    all.b -= each[best_out].b;
    fit = best;
  }
  return RobustHomography{.H = fit->H, .inlier = kept, .rms = fit->rms};
}

}  // namespace dockyard
