#include "controller/geometry/rational_distortion.h"

#include <Eigen/LU>

namespace dockyard {
namespace {

/// Bernstein coefficients of a polynomial of degree 6 over an interval: the polynomial lies between
/// the least and the greatest of them.
using Bernstein = std::array<double, 7>;

/// From coefficients of powers of s, over [0, end].
Bernstein BernsteinOver(const std::array<double, 7>& powers, double end) {
  constexpr double kChoose[7] = {1, 6, 15, 20, 15, 6, 1};
  Bernstein b{};
  double scale = 1.0;
  for (std::size_t i = 0; i < 7; ++i, scale *= end) b[i] = powers[i] * scale / kChoose[i];
  // b_j = sum over i <= j of (j choose i) of these: Pascal's triangle.
  for (std::size_t step = 1; step < 7; ++step) {
    for (std::size_t j = 6; j >= step; --j) b[j] += b[j - 1];
  }
  return b;
}

/// Whether the polynomial is positive on its whole interval.
bool Positive(Bernstein b, int halvings) {
  if (!(b.front() > 0.0) || !(b.back() > 0.0)) return false;  // its values at the ends
  bool all = true;
  for (const double value : b) all = all && value > 0.0;
  if (all) return true;
  if (halvings == 0) return false;
  Bernstein left{};  // de Casteljau at the middle; b ends as the right half
  for (std::size_t step = 0; step < 7; ++step) {
    left[step] = b[0];
    for (std::size_t j = 0; j + step + 1 < 7; ++j) b[j] = 0.5 * (b[j] + b[j + 1]);
  }
  return Positive(left, halvings - 1) && Positive(b, halvings - 1);
}

double Cubic(double c1, double c2, double c3, double s) {
  return 1.0 + s * (c1 + s * (c2 + s * c3));
}

}  // namespace

Eigen::Vector2d RationalDistortion::Distort(const Eigen::Vector2d& m, Eigen::Matrix2d& M) const {
  const double x = m.x(), y = m.y(), r2 = x * x + y * y;
  const double above = Cubic(k[0], k[1], k[2], r2), below = Cubic(k[3], k[4], k[5], r2);
  const double radial = above / below;
  const double d_above = k[0] + r2 * (2.0 * k[1] + r2 * 3.0 * k[2]);
  const double d_below = k[3] + r2 * (2.0 * k[4] + r2 * 3.0 * k[5]);
  const double slope = (d_above - radial * d_below) / below;  // d radial / d r^2
  const double mixed = 2.0 * x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y;
  M << radial + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x, mixed,  //
      mixed, radial + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

bool RationalDistortion::UnfoldedOutTo(double r2) const {
  // r P(r^2) / Q(r^2) has the slope (P Q + 2 s (P' Q - P Q')) / Q^2 with s = r^2.
  const double p[4] = {1.0, k[0], k[1], k[2]}, q[4] = {1.0, k[3], k[4], k[5]};
  std::array<double, 7> slope{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      slope[i + j] += p[i] * q[j] * (1.0 + 2.0 * (static_cast<double>(i) - static_cast<double>(j)));
    }
  }
  constexpr int kHalvings = 24;
  return Positive(BernsteinOver({1.0, q[1], q[2], q[3], 0.0, 0.0, 0.0}, r2), kHalvings) &&
         Positive(BernsteinOver(slope, r2), kHalvings);
}

bool RationalDistortion::Holds(const Eigen::Vector2d& m, const Eigen::Matrix2d& M) const {
  return M.determinant() > 0.0 && M.trace() > 0.0 && UnfoldedOutTo(m.squaredNorm());
}

std::optional<Eigen::Vector2d> RationalDistortion::Newton(Eigen::Vector2d m,
                                                          const Eigen::Vector2d& wanted) const {
  Eigen::Matrix2d M;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector2d miss = Distort(m, M) - wanted;
    // Strong barrel distortion folds the start: move it inwards until it unfolds.
    if (!(M.determinant() > 0.0 && M.trace() > 0.0)) {
      m *= 0.8;
      continue;
    }
    const Eigen::Vector2d step = M.inverse() * miss;
    m -= step;
    if (step.norm() < 1e-15 * (1.0 + m.norm())) break;
  }
  const double miss = (Distort(m, M) - wanted).norm();
  if (!(miss < 1e-12 * (1.0 + wanted.norm())) || !Holds(m, M)) return std::nullopt;
  return m;
}

/// The radius at which the radial part alone reaches `wanted`, or the last one before it folds.
double RationalDistortion::RadialStart(double wanted) const {
  const auto inside = [&](double r) {
    const double s = r * r;
    return UnfoldedOutTo(s) && r * Cubic(k[0], k[1], k[2], s) < wanted * Cubic(k[3], k[4], k[5], s);
  };
  double low = 0.0, high = 1e-3;
  while (high < 1e4 && inside(high)) {
    low = high;
    high *= 2.0;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (inside(middle) ? low : high) = middle;
  }
  return low;
}

std::optional<Eigen::Vector2d> RationalDistortion::Undistort(const Eigen::Vector2d& wanted,
                                                             Eigen::Vector2d* edge) const {
  if (const auto m = Newton(wanted, wanted)) return m;
  const double length = wanted.norm();
  const double start = RadialStart(length);
  const Eigen::Vector2d m = start / length * wanted;
  if (edge) *edge = m;
  return Newton(m, wanted);
}

}  // namespace dockyard
