// Lenses that divide a point's x and y by its depth behind spheres or an ellipsoid.
#include <cmath>

#include "controller/geometry/lens.h"
#include "controller/geometry/rational_distortion.h"

namespace dockyard {
namespace {

/// The depth by which x and y are divided, and its derivative by the point.
struct Depth {
  double value = 0.0;
  Eigen::RowVector3d by_p = Eigen::RowVector3d::Zero();
};

bool BeyondTheWidest(const Eigen::Vector3d& p) {
  return std::atan2(std::hypot(p.x(), p.y()), p.z()) > kWidestView_rad;
}

/// d (x, y) / depth by the point.
PixelJacobian Divided(const Eigen::Vector2d& m, const Depth& depth) {
  PixelJacobian by_p = -m * depth.by_p;
  by_p(0, 0) += 1.0;
  by_p(1, 1) += 1.0;
  return by_p / depth.value;
}

/// The pixel of a lens without further distortion.
template <typename L>
Eigen::Vector2d PixelOf(const L& lens, const Eigen::Vector3d& p, const Depth& depth,
                        PixelJacobian* J) {
  const Eigen::Vector2d m = p.head<2>() / depth.value;
  if (J) *J = Eigen::Vector2d(lens.fx, lens.fy).asDiagonal() * Divided(m, depth);
  return {lens.fx * m.x() + lens.cx, lens.fy * m.y() + lens.cy};
}

template <typename L>
Eigen::Vector2d OnThePlane(const L& lens, const Eigen::Vector2d& pixel) {
  return {(pixel.x() - lens.cx) / lens.fx, (pixel.y() - lens.cy) / lens.fy};
}

/// m drawn in to the greatest square of its length that has a ray.
void DrawIn(Eigen::Vector2d& m, double most_r2) {
  const double r2 = m.squaredNorm();
  if (r2 > most_r2) m *= std::sqrt(most_r2 / r2);
}

/// Where a depth alpha d + (1 - alpha) z stays positive and its image unfolded: z > -bound d.
double BoundOf(double alpha) {
  return alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha;
}

}  // namespace

std::optional<Eigen::Vector2d> DoubleSphere::Project(const Eigen::Vector3d& p,
                                                     PixelJacobian* J) const {
  const double d1 = p.norm();
  if (d1 == 0.0 || BeyondTheWidest(p)) return std::nullopt;
  const double z1 = p.z() + xi * d1;
  const double d2 = std::sqrt(p.x() * p.x() + p.y() * p.y() + z1 * z1);
  if (!(z1 > -BoundOf(alpha) * d2)) return std::nullopt;
  Depth depth{.value = alpha * d2 + (1.0 - alpha) * z1};
  if (!(depth.value > 0.0)) return std::nullopt;
  const Eigen::RowVector3d by_z1 = Eigen::RowVector3d::UnitZ() + xi / d1 * p.transpose();
  const Eigen::RowVector3d across(p.x(), p.y(), 0.0);
  depth.by_p = alpha / d2 * (across + z1 * by_z1) + (1.0 - alpha) * by_z1;
  return PixelOf(*this, p, depth, J);
}

LensRay DoubleSphere::Ray(const Eigen::Vector2d& pixel) const {
  Eigen::Vector2d m = OnThePlane(*this, pixel);
  if (alpha > 0.5) DrawIn(m, 1.0 / (2.0 * alpha - 1.0));
  const double r2 = m.squaredNorm();
  const double root = std::sqrt(std::max(1.0 - (2.0 * alpha - 1.0) * r2, 0.0));
  const double z = (1.0 - alpha * alpha * r2) / (alpha * root + 1.0 - alpha);
  const double scale = (z * xi + std::sqrt(z * z + (1.0 - xi * xi) * r2)) / (z * z + r2);
  const Eigen::Vector3d ray(scale * m.x(), scale * m.y(), scale * z - xi);
  return {.direction = ray.normalized()};
}

std::optional<Eigen::Vector2d> Eucm::Project(const Eigen::Vector3d& p, PixelJacobian* J) const {
  const double d = std::sqrt(beta * (p.x() * p.x() + p.y() * p.y()) + p.z() * p.z());
  if (d == 0.0 || BeyondTheWidest(p) || !(p.z() > -BoundOf(alpha) * d)) return std::nullopt;
  Depth depth{.value = alpha * d + (1.0 - alpha) * p.z()};
  if (!(depth.value > 0.0)) return std::nullopt;
  depth.by_p = alpha / d * Eigen::RowVector3d(beta * p.x(), beta * p.y(), p.z());
  depth.by_p.z() += 1.0 - alpha;
  return PixelOf(*this, p, depth, J);
}

LensRay Eucm::Ray(const Eigen::Vector2d& pixel) const {
  Eigen::Vector2d m = OnThePlane(*this, pixel);
  if (alpha > 0.5) DrawIn(m, 1.0 / (beta * (2.0 * alpha - 1.0)));
  const double r2 = beta * m.squaredNorm();
  const double root = std::sqrt(std::max(1.0 - (2.0 * alpha - 1.0) * r2, 0.0));
  const double z = (1.0 - alpha * alpha * r2) / (alpha * root + 1.0 - alpha);
  return {.direction = Eigen::Vector3d(m.x(), m.y(), z).normalized()};
}

std::optional<Eigen::Vector2d> Omni::Project(const Eigen::Vector3d& p, PixelJacobian* J) const {
  const double d = p.norm();
  const double bound = xi <= 1.0 ? xi : 1.0 / xi;
  if (d == 0.0 || BeyondTheWidest(p) || !(p.z() > -bound * d)) return std::nullopt;
  const Depth depth{.value = p.z() + xi * d,
                    .by_p = Eigen::RowVector3d::UnitZ() + xi / d * p.transpose()};
  const RationalDistortion distortion{{k1, k2, 0.0, 0.0, 0.0, 0.0}, p1, p2};
  const Eigen::Vector2d m = p.head<2>() / depth.value;
  Eigen::Matrix2d M;
  const Eigen::Vector2d bent = distortion.Distort(m, M);
  if (!distortion.Holds(m, M)) return std::nullopt;
  if (J) *J = Eigen::Vector2d(fx, fy).asDiagonal() * M * Divided(m, depth);
  return Eigen::Vector2d(fx * bent.x() + cx, fy * bent.y() + cy);
}

LensRay Omni::Ray(const Eigen::Vector2d& pixel) const {
  const RationalDistortion distortion{{k1, k2, 0.0, 0.0, 0.0, 0.0}, p1, p2};
  Eigen::Vector2d edge = Eigen::Vector2d::Zero();
  Eigen::Vector2d m = distortion.Undistort(OnThePlane(*this, pixel), &edge).value_or(edge);
  if (xi > 1.0) DrawIn(m, 1.0 / (xi * xi - 1.0));
  const double r2 = m.squaredNorm();
  const double root = std::sqrt(std::max(1.0 + (1.0 - xi * xi) * r2, 0.0));
  const double scale = (xi + root) / (r2 + 1.0);
  return {.direction = Eigen::Vector3d(scale * m.x(), scale * m.y(), scale - xi).normalized()};
}

}  // namespace dockyard
