#include "controller/vision/ellipse.h"

#include <Eigen/LU>
#include <cmath>

#include "controller/geometry/decompositions.h"

namespace dockyard {
namespace {

/// a x^2 + b xy + c y^2 + d x + e y + f = 0.
using Conic = Eigen::Matrix<double, 6, 1>;

std::optional<Conic> FitConic(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Matrix3d S1 = Eigen::Matrix3d::Zero(), S2 = S1, S3 = S1;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector3d quadratic(p.x() * p.x(), p.x() * p.y(), p.y() * p.y());
    const Eigen::Vector3d linear(p.x(), p.y(), 1.0);
    S1 += quadratic * quadratic.transpose();
    S2 += quadratic * linear.transpose();
    S3 += linear * linear.transpose();
  }
  Eigen::Matrix3d S3_inverse;
  bool invertible = false;  // not when the points lie on a line
  S3.computeInverseWithCheck(S3_inverse, invertible, 1e-12);
  if (!invertible) return std::nullopt;
  const Eigen::Matrix3d T = -S3_inverse * S2.transpose();
  const Eigen::Matrix3d M = S1 + S2 * T;
  Eigen::Matrix3d constrained;  // inverse of the ellipse constraint 4ac - b^2 = 1, times M
  constrained << M.row(2) / 2.0, -M.row(1), M.row(0) / 2.0;
  const GeneralEigen eigen = EigenOf(constrained);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = eigen.vectors.col(i).real();
    if (4.0 * a(0) * a(2) - a(1) * a(1) <= 0.0) continue;
    Conic conic;
    conic << a, T * a;
    return conic;
  }
  return std::nullopt;
}

std::optional<Ellipse> FromConic(const Conic& q) {
  Eigen::Matrix2d A;
  A << q(0), q(1) / 2.0, q(1) / 2.0, q(2);
  if (std::abs(A.determinant()) < 1e-12 * A.squaredNorm()) return std::nullopt;
  const Eigen::Vector2d centre = -0.5 * A.inverse() * q.segment<2>(3);
  const double level = centre.dot(A * centre) - q(5);
  A /= level;
  const double det = A.determinant(), trace = A.trace();
  if (!(det > 0.0) || !(trace > 0.0)) return std::nullopt;
  // The square root of a positive 2 x 2 matrix (Cayley-Hamilton), and its inverse.
  const Eigen::Matrix2d root =
      (A + std::sqrt(det) * Eigen::Matrix2d::Identity()) / std::sqrt(trace + 2.0 * std::sqrt(det));
  return Ellipse{.centre_px = centre, .shape_px = root.inverse()};
}

}  // namespace

double Ellipse::mean_radius_px() const { return std::sqrt(shape_px.determinant()); }

Eigen::Vector2d Ellipse::semi_axes_px() const {
  const double half = 0.5 * shape_px.trace();
  const double apart = std::hypot(0.5 * (shape_px(0, 0) - shape_px(1, 1)), shape_px(0, 1));
  return {half - apart, half + apart};
}

Eigen::Vector2d Ellipse::ToDisc(const Eigen::Vector2d& pixel) const {
  return shape_px.inverse() * (pixel - centre_px);
}

std::optional<Ellipse> FitEllipse(const std::vector<Eigen::Vector2d>& rim_px) {
  if (rim_px.size() < 5) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : rim_px) mean += p;
  mean /= static_cast<double>(rim_px.size());
  double spread = 0.0;
  for (const Eigen::Vector2d& p : rim_px) spread += (p - mean).norm();
  spread /= static_cast<double>(rim_px.size());
  if (!(spread > 1e-9)) return std::nullopt;
  std::vector<Eigen::Vector2d> unit;  // centred and scaled: the fit is then well conditioned
  unit.reserve(rim_px.size());
  for (const Eigen::Vector2d& p : rim_px) unit.emplace_back((p - mean) / spread);
  const std::optional<Conic> conic = FitConic(unit);
  if (!conic) return std::nullopt;
  const std::optional<Ellipse> ellipse = FromConic(*conic);
  if (!ellipse || !ellipse->shape_px.allFinite()) return std::nullopt;
  return Ellipse{.centre_px = mean + spread * ellipse->centre_px,
                 .shape_px = spread * ellipse->shape_px};
}

}  // namespace dockyard
